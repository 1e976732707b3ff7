// SPDX-License-Identifier: MIT
// The state of a follower at one cam angle: the input of every cam generator.
#pragma once

namespace camopt {

/// Displacement and its derivatives by the cam angle, SI: m, m/rad, m/rad² (rad, 1, 1/rad where it swings).
struct FollowerState {
    double s = 0.0, velocity = 0.0, acceleration = 0.0;  ///< s, s', s''
};

}  // namespace camopt
