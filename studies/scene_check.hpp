// SPDX-License-Identifier: MIT
// What can be said of a scene without solving it: that its problem can be built, how large it is, and that
// its derivatives agree with differences.
#pragma once

#include "core/scene.hpp"
#include "objectives/point_rule.hpp"
#include "studies/solve.hpp"

#include <string>
#include <vector>

namespace camopt {

/// Largest disagreement of one kind of derivative, |exact − difference| / max(1, |exact|, |difference|).
struct DerivativeError {
    std::string kind;   ///< "gradient", "jacobian", "hessian"
    std::string where;  ///< the entry, by names
    double error = 0.0;
};

/// A limit of the scene as the optimizer sees it.
struct LimitShape {
    std::string key;  ///< "limits.pressure_angle_deg"
    Curvature curvature = Curvature::general;
};

struct SceneCheck {
    BackendChoice choice;
    int variables = 0, rows = 0;  ///< of the first grid
    bool convex = false;
    std::vector<LimitShape> limits;  ///< each once, with the worst of its parts, in the scene's order
    std::vector<DerivativeError> derivatives;
    bool derivatives_agree = false;
    std::vector<std::string> redundant;       ///< conditions that follow from others
    std::vector<std::string> contradictions;  ///< conditions that cannot be met together: infeasible
};

/// Throws InputError for a wrong scene, as solve() does.
[[nodiscard]] SceneCheck check_scene(const Scene& scene);

}  // namespace camopt
