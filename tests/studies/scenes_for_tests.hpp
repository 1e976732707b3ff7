// SPDX-License-Identifier: MIT
// Parts of scenes that tests of studies/ build in C++, as an embedder does.
#pragma once

#include "core/units.hpp"
#include "scene/scene.hpp"
#include "solvers/registry.hpp"

#include <array>

namespace camopt::testing_support {

inline Scene with_weights(Scene scene, const std::array<double, 3>& of_velocity_acceleration_jerk) {
    scene.objective.velocity = of_velocity_acceleration_jerk[0];
    scene.objective.acceleration = of_velocity_acceleration_jerk[1];
    scene.objective.jerk = of_velocity_acceleration_jerk[2];
    return scene;
}

/// The paper's objective with its rounded references: the setting of the reference figures.
inline Scene paper_objective(MotionType type, int degree, int segments) {
    Scene scene = with_weights({}, {0.4, 0.4, 0.2});
    scene.motion.type = type;
    scene.spline.degree = degree;
    scene.spline.segments = segments;
    Reference& reference = scene.objective.reference;
    reference.numeric = true;
    reference.velocity = 1.76;
    reference.acceleration = 5.53;
    reference.jerk = 69.0;
    return scene;
}

inline ProgramSegment dwell(double degrees) {
    return {SegmentKind::dwell, degrees * units::degree, "", {}};
}
inline ProgramSegment spline(double degrees, std::optional<double> to = {}) {
    return {SegmentKind::spline, degrees * units::degree, "", to};
}
inline ProgramSegment law(double degrees, const char* key, std::optional<double> to = {}) {
    return {SegmentKind::law, degrees * units::degree, key, to};
}
/// With the paper's objective; lift 20 mm.
inline Scene program(std::vector<ProgramSegment> segments, int spline_segments = 12) {
    Scene scene = paper_objective(MotionType::program, 3, spline_segments);
    scene.motion.lift = 20e-3;
    scene.motion.segments = std::move(segments);
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
inline WrittenLimit degrees(double value, const char* key) {
    return {value * units::degree, key, units::degree, "deg"};
}
inline WrittenLimit millimetres(double value, const char* key) {
    return {value * units::millimetre, key, units::millimetre, "mm"};
}

}  // namespace camopt::testing_support
