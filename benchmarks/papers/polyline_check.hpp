// SPDX-License-Identifier: MIT
// A guide by points of its middle line alone: the roller's centre runs along straight lines between them. The
// simplest of the checks of paper 000; studies/inverse/inverse_forward.hpp has the slot.
#pragma once

#include "studies/inverse/inverse_forward.hpp"

namespace camopt {

/// Lengths m, angles rad. Needs two points or more; where the lines do not reach, the deviation is infinite.
[[nodiscard]] GuideCheckResult polyline_check(const GuideCheckInput& input);

}  // namespace camopt
