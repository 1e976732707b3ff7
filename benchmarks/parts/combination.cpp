// SPDX-License-Identifier: MIT
#include "benchmarks/parts/combination.hpp"

#include "solvers/registry.hpp"
#include "studies/papers/paper_report.hpp"
#include "studies/papers/reference_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace camopt::benchmarks {

namespace {

struct MotionKind {
    MotionType motion;
    int degree;
};

// Local methods, each of a kind of its own; those that search at random have no place here.
constexpr std::string_view backends[] = {"structured",   "ipopt",     "nlopt.slsqp",
                                         "nlopt.cobyla", "nlopt.mma", "nlopt.ccsaq"};

/// Where a backend or a design vector is dense, larger problems take minutes and gigabytes.
int most_segments(const std::string& backend, DesignKind design) {
    if (backend.starts_with("nlopt.")) return 128;
    return design == DesignKind::states ? 16384 : 256;
}

/// The looser tolerance gets fewer n: it is there to compare, not to be looked up.
std::vector<int> segments_of(const std::string& backend, DesignKind design, double tolerance) {
    std::vector<int> segments = {4,  6,  8,   10,  12,  16,   24,   32,   48,
                                 64, 96, 128, 256, 512, 1024, 2048, 4096, 16384};
    if (tolerance > 1e-9) segments = {8, 12, 16, 32, 64, 128, 256, 1024, 4096, 16384};
    std::erase_if(segments, [&](int n) { return n > most_segments(backend, design); });
    return segments;
}

double weighted(double velocity, double acceleration, double jerk) {
    return paper::weights[0] * velocity / paper::velocity_reference +
           paper::weights[1] * acceleration / paper::acceleration_reference +
           paper::weights[2] * jerk / paper::jerk_reference;
}

}  // namespace

const char* motion_name(MotionType motion) {
    return motion == MotionType::drd ? "DRD" : "RR";
}

std::string Combination::series() const {
    return fmt::format("{} {} {} {} {:g}", backend, degree, motion_name(motion), name_of(design), tolerance);
}

std::string Combination::optimum() const {
    return fmt::format("{} {} {}", degree, motion_name(motion), segments);
}

std::vector<Combination> combinations() {
    std::vector<Combination> all;
    for (const SolverEntry& entry : solver_entries()) {
        if (std::ranges::find(backends, entry.name) == std::end(backends)) continue;
        for (const MotionKind kind :
             {MotionKind{MotionType::drd, 3}, {MotionType::rr, 3}, {MotionType::drd, 5}})
            for (const DesignKind design :
                 {DesignKind::states, DesignKind::coefficients, DesignKind::ordinates})
                for (const double tolerance : {1e-9, 1e-6})
                    for (const int segments : segments_of(entry.name, design, tolerance))
                        all.push_back({entry.name, kind.degree, kind.motion, design, segments, tolerance});
    }
    return all;
}

Scene scene_of(const Combination& combination, double max_seconds) {
    Scene scene = paper_scene(combination.segments, paper::weights[0], paper::weights[1], paper::weights[2]);
    scene.motion.type = combination.motion;
    scene.motion.rise = 2.0;  // any angle that leaves room for the return: the study is dimensionless
    scene.motion.symmetric = false;
    scene.spline.degree = combination.degree;
    scene.spline.design = combination.design;
    scene.objective.tie_break = TieBreak::none;
    scene.solver.name = combination.backend;
    scene.solver.tolerance = combination.tolerance;
    scene.solver.max_seconds = max_seconds;
    return scene;
}

std::optional<double> exact_optimum(const Combination& combination) {
    if (combination.motion != MotionType::drd || combination.degree != 3) return {};
    switch (combination.segments) {
        case 4:
            return weighted(2.0, 8.0, 32.0);
        case 6:
            return weighted(2.0, 6.0, 36.0);
        case 8:
            return weighted(2.0, 16.0 / 3.0, 128.0 / 3.0);
        case 10:
            return weighted(5.0 / 3.0, 50.0 / 9.0, 500.0 / 9.0);
        case 12:
            return weighted(12.0 / 7.0, 36.0 / 7.0, 432.0 / 7.0);
        default:
            return {};
    }
}

}  // namespace camopt::benchmarks
