// SPDX-License-Identifier: MIT
// motion.svg: displacement, velocity, acceleration and jerk of the optimum over the cam angle, stacked, with
// the reference law dashed, the limits dotted, the peaks marked and the verdict in the title.
#pragma once

#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt {

/// Throws InputError where the solution has no curve.
[[nodiscard]] std::string motion_svg(const Solution& solution);

}  // namespace camopt
