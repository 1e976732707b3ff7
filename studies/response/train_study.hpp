// SPDX-License-Identifier: MIT
// An elastic follower train over a range of speeds: the optimum compared with laws in its place, each stroke
// from rest, and the optimum's steady state where the turn is closed and damped. A stroke is everything
// between two dwells.
#pragma once

#include "objectives/response/train_figures.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// One stroke of one motion at one speed, from rest.
struct TrainRow {
    std::string motion;              ///< "optimum", "static_optimum", "polydyne", or the key of a law
    int stroke = 1;                  ///< from 1
    double speed = 0.0;              ///< rad/s
    double frequency_ratio = 0.0;    ///< time of the stroke over the natural period of the slowest mode
    double residual = 0.0;           ///< amplitude in lifts
    double peak_deflection = 0.0;    ///< |x − y| in lifts
    double peak_acceleration = 0.0;  ///< |x''|, normalised as A
    std::optional<double>
        least_force;  ///< on the cam, the dwell after it too, N or N m; none: cam-guided both ways
    [[nodiscard]] bool lifts_off() const { return least_force && *least_force < 0.0; }
};

/// One instant of the first stroke.
struct TrainInstant {
    double x = 0.0;                    ///< cam angle by the unit angle, from its begin on
    double input = 0.0, output = 0.0;  ///< y, x_n in lifts, but for the constant compression
    double input_acceleration = 0.0, acceleration = 0.0;  ///< in lifts by x²
    double force = 0.0;                                   ///< on the cam, N or N m
};
struct TrainHistory {
    std::string motion;
    double speed = 0.0;
    std::vector<TrainInstant> instants;
};

/// What is left after a motion where the train is not as it was thought to be: the largest amplitude after a
/// stroke at the scene's speed, in lifts, by factors on its natural frequencies, damping in proportion.
struct DetunedRow {
    std::string motion;
    std::array<double, 3> residual{};
};
inline constexpr std::array detuning = {0.9, 1.0, 1.1};

/// Steady state of a closed turn: amplitudes once everything repeats.
struct SteadyRow {
    double speed = 0.0;
    double peak_deflection = 0.0, peak_acceleration = 0.0;
    std::optional<double> least_force;
};

struct TrainStudy {
    Scene scene;
    std::vector<double> natural_frequencies;                   ///< rad/s, ascending
    std::vector<double> speeds;                                ///< rad/s
    std::vector<MotionEvent> strokes;                          ///< of all motions
    std::vector<std::pair<std::string, std::string>> motions;  ///< key and title
    std::vector<TrainRow> rows;  ///< stroke by stroke, in it motion by motion, speed by speed
    /// Stroke by stroke, motion by motion: the lowest speed up to the highest looked at, or twice that, where
    /// contact is lost; none: nowhere.
    std::vector<std::optional<double>> lift_off_speeds;
    std::vector<DetunedRow> detuned;      ///< motion by motion; empty: the train does not vibrate
    std::vector<TrainHistory> histories;  ///< at the scene's speed: optimum, static optimum, reference law
    std::vector<SteadyRow> steady;        ///< of the optimum; empty: no closed turn, or no damping
    Solution optimum;
    std::optional<Solution>
        static_optimum;  ///< without terms and limits of the train; none: the scene has none
};

/// rad/s, evenly. Throws InputError for a count below 1 or speeds that do not ascend.
struct SpeedSweep {
    double from = 0.0, to = 0.0;
    int count = 0;
};
/// The default: from half the least to twice the largest speed of the range, 61 of them.
[[nodiscard]] SpeedSweep default_speeds(const Scene& scene);

/// Solves the scene (and it without its train), then looks at all motions. Throws InputError for a scene
/// without dynamics.
[[nodiscard]] TrainStudy train_study(const Scene& scene, const SpeedSweep& speeds,
                                     const SolveControl& control = {});
/// The same of a scene that is solved.
[[nodiscard]] TrainStudy train_study_of(Solution optimum, std::optional<Solution> static_optimum,
                                        const SpeedSweep& speeds);
/// The scene as if its follower were rigid.
[[nodiscard]] Scene without_train(const Scene& scene);

}  // namespace camopt
