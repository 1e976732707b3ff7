// SPDX-License-Identifier: MIT
// What a user could change about an infeasible scene, one number at a time.
#pragma once

#include "core/scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace camopt {

/// One number of a scene. Values are in the unit of the key.
struct Adjustment {
    std::string key;  ///< "limits.pressure_angle_deg"
    double given = 0.0;
    double step = 0.0;  ///< the first change to try, > 0
    bool may_grow = true, may_shrink = true;
    double least = 0.0, most = 0.0;  ///< the range it may move in
    std::function<Scene(double value)> with;
};

/// Every limit but the caps on peaks, the rise angle, and every dimension of the cam.
[[nodiscard]] std::vector<Adjustment> adjustments(const Scene& scene);

}  // namespace camopt
