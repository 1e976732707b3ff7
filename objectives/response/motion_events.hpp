// SPDX-License-Identifier: MIT
// Excitation of a follower train: everything between two dwells, and the dwell after it, with free vibration.
#pragma once

#include "scene/scene.hpp"

#include <vector>

namespace camopt {

/// Consecutive stretches of x: one, or two if it crosses the end of a closed program.
struct MotionStretch {
    double begin = 0.0, end = 0.0;
};

struct MotionEvent {
    std::vector<MotionStretch> moving;
    std::vector<MotionStretch>
        dwell;  ///< may lie beyond the motion: DRD and RR rest for the rest of the revolution
};

/// In the order of the cam angle. A closed program without a dwell has none.
[[nodiscard]] std::vector<MotionEvent> motion_events(const MotionSpec& motion);

/// One rise from rest over [0, 1], and a dwell for the rest: used to compare laws.
[[nodiscard]] MotionEvent single_rise(double unit_angle);

}  // namespace camopt
