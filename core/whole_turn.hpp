// SPDX-License-Identifier: MIT
// Whether a cam goes once around.
#pragma once

#include "core/units.hpp"

#include <cmath>

namespace camopt {

/// An angle of rad that is one turn but for the rounding of sums and units.
[[nodiscard]] inline bool is_whole_turn(double angle) {
    constexpr double rounding = 1e-9;  // rad: far above that of sums, far below any stretch of a motion
    return std::abs(angle - units::turn) < rounding;
}

}  // namespace camopt
