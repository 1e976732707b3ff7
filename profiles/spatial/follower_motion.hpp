// SPDX-License-Identifier: MIT
// The motion of a follower over the cam angle, the input of the generators of whole surfaces.
#pragma once

#include "core/follower_state.hpp"

#include <functional>
#include <vector>

namespace camopt {

/// s, s', s'' by the cam angle θ (rad) in SI.
struct FollowerMotion {
    /// Where s'' jumps the limit from above (at the end from below).
    std::function<FollowerState(double theta)> state;
    /// Ascending cam angles where the motion changes its formula; begin and end are the first and the last.
    std::vector<double> breakpoints;

    [[nodiscard]] double begin() const { return breakpoints.front(); }
    [[nodiscard]] double end() const { return breakpoints.back(); }
};

}  // namespace camopt
