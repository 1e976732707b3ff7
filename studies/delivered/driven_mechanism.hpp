// SPDX-License-Identifier: MIT
// A cam of any kind along a motion: its points.
#pragma once

#include "core/motion.hpp"
#include "profiles/sampling.hpp"
#include "scene/cam_mechanism.hpp"

#include <vector>

namespace camopt {

[[nodiscard]] MechanismPoint mechanism_point(const DrivenMechanism& mechanism, const MotionPoint& motion,
                                             const MotionScale& scale, int station = 0);

/// About `count` points of one station, evenly by cam angle, the motion's breakpoints among them, and which
/// those are. Throws InputError for fewer than 2.
struct MechanismProfile {
    std::vector<MechanismPoint> points;
    std::vector<double> outputs;  ///< s of each, m or rad
    std::vector<int> breaks;
};
[[nodiscard]] MechanismProfile mechanism_profile(const DrivenMechanism& mechanism, const Motion& motion,
                                                 const MotionScale& scale, int count, int station = 0);

}  // namespace camopt
