// SPDX-License-Identifier: MIT
// Scenes the tests of studies/ share.
#pragma once

#include "scene/scene.hpp"
#include "solvers/registry.hpp"

namespace camopt::testing_support {

/// The paper's objective with its rounded references: the setting of the reference figures.
inline Scene paper_objective(MotionType type, int degree, int segments) {
    Scene scene;
    scene.motion.type = type;
    scene.spline.degree = degree;
    scene.spline.segments = segments;
    scene.objective.velocity = 0.4;
    scene.objective.acceleration = 0.4;
    scene.objective.jerk = 0.2;
    Reference& reference = scene.objective.reference;
    reference.numeric = true;
    reference.velocity = 1.76;
    reference.acceleration = 5.53;
    reference.jerk = 69.0;
    return scene;
}

inline bool is_available(const std::string& solver) {
    if (solver == "auto") return true;
    for (const SolverEntry& entry : solver_entries()) {
        if (entry.name == solver) return entry.available;
    }
    return false;
}

inline PeakLimit normalised_limit(const char* key, double value) {
    return {value, key, value, ""};
}

}  // namespace camopt::testing_support
