// SPDX-License-Identifier: MIT
// One cell of the error-against-run-time study: which motion, which spline, which design vector, which
// backend.
#pragma once

#include "scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace camopt::benchmarks {

struct Combination {
    std::string backend;
    int degree = 3;
    MotionType motion = MotionType::drd;
    DesignKind design = DesignKind::states;
    int segments = 0;
    double tolerance = 1e-9;

    /// The same backend, degree, motion, design and tolerance: n runs along a series.
    [[nodiscard]] std::string series() const;
    /// The same optimum: degree, motion and n, whatever finds it.
    [[nodiscard]] std::string optimum() const;
};

/// Every combination of the study, n ascending within a series; backends that camopt knows.
[[nodiscard]] std::vector<Combination> combinations();

/// Weights 0.4, 0.4, 0.2 over 1.76, 5.53, 69 (MotionType::rr: return as long as the rise), no tie-break.
[[nodiscard]] Scene scene_of(const Combination& combination, double max_seconds);

/// The optimum as a fraction, known for DRD cubic with 4, 6, 8, 10, 12 segments.
[[nodiscard]] std::optional<double> exact_optimum(const Combination& combination);

[[nodiscard]] const char* motion_name(MotionType motion);

}  // namespace camopt::benchmarks
