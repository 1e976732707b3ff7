// SPDX-License-Identifier: MIT
// Peaks, root mean squares and the objective of a motion, from their definitions (docs/scene_file.md).
#pragma once

#include "tests/soak/figures/motion.hpp"

#include <array>
#include <map>
#include <string>

namespace camopt::soak {

/// Of the scene's elastic follower, from rest.
struct TrainFigures {
    double residual = 0.0;     ///< lifts; 0: damped above critical
    double least_force = 0.0;  ///< N, over the motion, at 64 places a piece: no less than the truth
};

struct MotionFigures {
    /// max |y'|, |y''|, |y'''| by order; of a program the largest over its strokes, each by its own angle and
    /// displacement.
    std::array<long double, 4> peak{};
    /// The same of the whole motion in lifts and units of x, laws included: what limits in time are about.
    std::array<long double, 4> whole{};
    long double torque = 0;            ///< max |y' y''|
    std::array<long double, 4> rms{};  ///< by order; DRD and RR
    /// What the last digit of a published control point is worth in y and its derivatives on the narrowest
    /// piece: no reader of the file knows these better.
    std::array<long double, 4> rounding{};
    std::vector<std::array<long double, 4>> of_stretch;  ///< peaks of each segment by its own measure
    std::vector<std::array<long double, 4>> by_x;        ///< the same in lifts and units of x
    TrainFigures train;
};

[[nodiscard]] MotionFigures figures_of(const Motion& motion);

/// In 113 bits (benchmarks/trains/exact_chain.hpp), from the pieces of a rise and the scene's train alone.
[[nodiscard]] TrainFigures train_figures(const SceneNumbers& scene, const Motion& motion);

/// The sum of the weighted terms. `dimensions`: of the delivered cam, m.
[[nodiscard]] long double objective_of(const SceneNumbers& scene, const MotionFigures& figures,
                                       const std::map<std::string, double>& dimensions);

}  // namespace camopt::soak
