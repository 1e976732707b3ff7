// SPDX-License-Identifier: MIT
// A cam of any kind along a motion: its points, and its limits enclosed.
#pragma once

#include "core/motion.hpp"
#include "profiles/sampling.hpp"
#include "scene/cam_mechanism.hpp"
#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace camopt {

/// About `count` points of one station, evenly by cam angle, the motion's breakpoints among them, and which
/// those are. Throws InputError for fewer than 2.
struct MechanismProfile {
    std::vector<MechanismPoint> points;
    std::vector<double> outputs;  ///< s of each, m or rad
    std::vector<int> breaks;
};
[[nodiscard]] MechanismProfile mechanism_profile(const DrivenMechanism& mechanism, const Motion& motion,
                                                 const MotionScale& scale, int count, int station = 0);

// A second look at every limit on the cam of a delivered motion: not at points, but along every stretch of
// it.

/// One rule that keeps a limit, along the whole motion.
struct EnclosedLimit {
    std::string key;     ///< "limits.pressure_angle_deg"
    double worst = 0.0;  ///< relative to the rule's scale; above 0 the limit is passed; infinite: no value
    double at = 0.0;     ///< x
    /// No larger one hides between points: enclosed by interval arithmetic, at every station there is.
    bool complete = false;
};

/// Of every rule of the scene's limits on its cam, whose formulas and numbers are `cam`.
[[nodiscard]] std::vector<EnclosedLimit> enclosed_limits(const Scene& scene, const DrivenMechanism& cam,
                                                         const Motion& motion);

/// All rules of a limit are complete, and there is one.
[[nodiscard]] bool is_verified(const std::vector<EnclosedLimit>& limits, const std::string& key);

}  // namespace camopt
