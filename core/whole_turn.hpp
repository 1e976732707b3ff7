// SPDX-License-Identifier: MIT
// Whether a cam makes one revolution.
#pragma once

#include "core/units.hpp"

#include <cmath>

namespace camopt {

/// An angle of rad that is one revolution to within the rounding of sums and units.
[[nodiscard]] inline bool is_whole_turn(double angle) {
    constexpr double rounding = 1e-9;  // rad: far above round-off of sums, far below any segment of a motion
    return std::abs(angle - units::turn) < rounding;
}

}  // namespace camopt
