// SPDX-License-Identifier: MIT
// Laws of the catalogue in the place of a solution's motion, for the curves of its page.
//
//   key, title
//   misfit     null, or why the law does not fit the scene: then there are no curves
//   curves     displacement, velocity, acceleration, jerk: values[] by the angles and in the units of
//   page_data
//              (null: infinite, or in the dwell behind the motion)
//   peaks      velocity, acceleration, jerk, normalised as the scene's; null where infinite
#pragma once

#include "studies/delivered/solution.hpp"

#include <span>
#include <string>

namespace camopt {

/// A JSON array, one entry a key, in their order; [] for a solution without a motion. Throws InputError for a
/// law that is not in the catalogue.
[[nodiscard]] std::string page_laws(const Solution& solution, std::span<const std::string> keys);

}  // namespace camopt
