// SPDX-License-Identifier: MIT
// What sets a follower train vibrating: everything between two dwells, and the dwell after it, in which it
// rings.
#pragma once

#include "scene/scene.hpp"

#include <vector>

namespace camopt {

/// Stretches of x that follow each other: one, or two where it runs across the end of a closed turn.
struct MotionStretch {
    double begin = 0.0, end = 0.0;
};

struct MotionEvent {
    std::vector<MotionStretch> moving;
    std::vector<MotionStretch>
        dwell;  ///< may lie beyond the motion: DRD and RR rest for the rest of the turn
};

/// In the order of the cam angle. A closed program without a dwell has none.
[[nodiscard]] std::vector<MotionEvent> motion_events(const MotionSpec& motion);

/// One rise from rest over [0, 1], and the rest of the turn: what laws are compared by.
[[nodiscard]] MotionEvent single_rise(double unit_angle);

}  // namespace camopt
