// SPDX-License-Identifier: MIT
// A cam of any mechanism along a motion: its points, its extremes over the cam angle and all stations.
#pragma once

#include "core/motion.hpp"
#include "profiles/sampling.hpp"
#include "scene/cam_mechanism.hpp"
#include "studies/delivered/extremes_along.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace camopt {

/// A mechanism with its numbers, driven by a motion.
struct DrivenMechanism {
    std::shared_ptr<const CamMechanism> formulas;
    std::vector<double> dimensions;
};

struct MechanismSummary {
    CamExtreme pressure_angle;  ///< largest |φ|
    std::optional<CamExtreme>
        convex_radius;  ///< least, of the cam surface; planar, none where nowhere convex
    std::optional<CamExtreme> concave_radius;  ///< least, > 0; planar, none where nowhere concave
    CamExtreme regularity;                     ///< least; <= 0: undercut
    double base_radius = 0.0;  ///< planar: least distance of the cam's surface from its centre, m

    [[nodiscard]] bool undercut() const { return !(regularity.value > 0.0); }
};

[[nodiscard]] MechanismPoint mechanism_point(const DrivenMechanism& mechanism, const MotionPoint& motion,
                                             const MotionScale& scale, int station = 0);

[[nodiscard]] MechanismSummary mechanism_summary(const DrivenMechanism& mechanism, const Motion& motion,
                                                 const MotionScale& scale);

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
