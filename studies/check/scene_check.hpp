// SPDX-License-Identifier: MIT
// What can be said of a scene without solving it: that its problem can be built, how large it is, and that
// its derivatives agree with differences.
#pragma once

#include "objectives/rules/point_rule.hpp"
#include "studies/search/plan.hpp"

namespace camopt {

/// Largest disagreement of one kind of derivative with differences
/// (studies/check/scene_check.cpp). An entry is wrong where it is off by many times the estimated
/// error of its difference.
struct DerivativeError {
    std::string kind;     ///< "gradient", "jacobian", "hessian"
    std::string where;    ///< the worst entry, by names
    double error = 0.0;   ///< its |exact − difference| / max(1, |exact|, |difference|)
    double beyond = 0.0;  ///< of a wrong entry: |exact − difference| / estimated error; else 0
    long wrong = 0, entries = 0;
};

/// The three kinds, at a point; of a large problem only some columns. Multipliers of the Hessian are seeded.
[[nodiscard]] std::vector<DerivativeError> derivative_errors(const Nlp& problem, const Eigen::VectorXd& x);

/// A limit of the scene as the optimizer sees it.
struct LimitShape {
    std::string key;  ///< "limits.pressure_angle_deg"
    Curvature curvature = Curvature::general;
};

struct SceneCheck {
    SolvePlan plan;
    int variables = 0, rows = 0;     ///< of the first grid
    std::vector<LimitShape> limits;  ///< each once, with the worst of its parts, in the scene's order
    std::vector<DerivativeError> derivatives;
    bool derivatives_agree = false;
    std::vector<std::string> redundant;       ///< conditions that follow from others
    std::vector<std::string> contradictions;  ///< conditions that cannot be met together: infeasible
};

/// Throws InputError for a wrong scene, as solve() does.
[[nodiscard]] SceneCheck check_scene(const Scene& scene);

}  // namespace camopt
