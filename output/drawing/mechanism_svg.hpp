// SPDX-License-Identifier: MIT
// mechanism.svg: a planar cam mechanism to scale. The cam and its pitch curve at cam angle 0, roller, levers,
// couplers and slider there, and thin the links at the two ends of the output's motion; beside it dimensions
// and figures. The frame that stands still.
#pragma once

#include "core/motion.hpp"
#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt {

/// Along this motion (drawn_motion of studies/delivered/delivered.hpp). Throws InputError for a mechanism
/// that cannot be drawn.
[[nodiscard]] std::string mechanism_svg(const Solution& solution, const Motion& motion);

}  // namespace camopt
