// SPDX-License-Identifier: MIT
// A second look at every limit on the cam of a delivered motion: not at points, but along every stretch of
// it.
#pragma once

#include "scene/cam_mechanism.hpp"
#include "scene/scene.hpp"

#include <string>
#include <vector>

namespace camopt {

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
