// SPDX-License-Identifier: MIT
#include "benchmarks/combination.hpp"

#include "studies/paper_tables.hpp"
#include "studies/reference_table.hpp"

#include <fmt/format.h>

namespace camopt::benchmarks {

namespace {

struct MotionKind {
    MotionType motion;
    int degree;
};

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
    return fmt::format("{} {} {} {}", backend, degree, motion_name(motion), name_of(design));
}

std::string Combination::optimum() const {
    return fmt::format("{} {} {}", degree, motion_name(motion), segments);
}

std::vector<Combination> combinations() {
    std::vector<Combination> all;
    for (const char* backend : {"structured", "ipopt", "nlopt.slsqp", "nlopt.cobyla"})
        for (const MotionKind kind :
             {MotionKind{MotionType::drd, 3}, {MotionType::drd, 5}, {MotionType::rr, 3}})
            for (const DesignKind design :
                 {DesignKind::ordinates, DesignKind::coefficients, DesignKind::states})
                for (const int segments : {4, 6, 8, 10, 12, 16, 24, 32, 48, 64})
                    all.push_back({backend, kind.degree, kind.motion, design, segments});
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
