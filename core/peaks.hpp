// SPDX-License-Identifier: MIT
// The peaks of a motion: the figures cams are chosen by.
#pragma once

#include "core/numbers/extremum.hpp"

namespace camopt {

/// V, A, J = max |y'|, |y''|, |y'''|; torque Q = max |y'·y''|. Each Extremum carries the magnitude (>= 0,
/// possibly infinite) and where it is reached. rms = square root of the mean square over the motion.
struct Peaks {
    Extremum velocity;
    Extremum acceleration;
    Extremum jerk;
    Extremum torque;
    double rms_velocity = 0.0;
    double rms_acceleration = 0.0;
    double rms_jerk = 0.0;
};

}  // namespace camopt
