// SPDX-License-Identifier: MIT
// What a user could change about an infeasible scene, one number at a time.
#pragma once

#include "scene/scene.hpp"

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
    /// That scene with the value.
    std::function<Scene(const Scene& scene, double value)> with;
    /// A limit: whatever keeps it keeps every looser one, so that its end settles it.
    bool limit = false;
};

/// Every limit but the caps on peaks, the rise angle, every dimension of the cam, its springs and its speed.
[[nodiscard]] std::vector<Adjustment> adjustments(const Scene& scene);

/// The caps on peaks.
[[nodiscard]] std::vector<Adjustment> peak_adjustments(const Scene& scene);

/// Preload, spring rate, width of contact, and the speed that forces and limits in time go by.
[[nodiscard]] std::vector<Adjustment> operating_adjustments(const Scene& scene);

/// Limits in time keep their meaning when a unit of x takes `ratio` times the time it took.
void rescale_limits_in_time(Scene& scene, double ratio);

}  // namespace camopt
