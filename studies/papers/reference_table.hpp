// SPDX-License-Identifier: MIT
// The published spline-versus-modified-sine tables beside what is true: the printed figure, the exact
// evaluation of the printed points, the proved optimum, and the lower bound for every curve.
#pragma once

#include "studies/delivered/solution.hpp"
#include "studies/papers/paper_report.hpp"

namespace camopt {

struct PeakFigures {
    double velocity = 0.0, acceleration = 0.0, jerk = 0.0, objective = 0.0;
};

/// Tables 1 and 2, one row per number of segments. Rows beyond the paper's have nothing printed.
struct ConvergenceRow {
    int segments = 0;
    std::optional<PeakFigures> printed;             ///< Table 2
    std::vector<double> printed_points;             ///< Table 1: y_0 … y_n, empty where not printed
    std::optional<PeakFigures> points_exact;        ///< the printed points, evaluated exactly
    std::optional<double> points_end_acceleration;  ///< their y''(0), which should be 0
    std::optional<PeakFigures> corrected_exact;     ///< n = 10: with the misprinted ordinate put right
    Solution optimum;                               ///< proved
    std::vector<double> optimum_points;             ///< y_0 … y_n of the proved optimum
    std::string note;                               ///< why figures differ, in words
};

/// Table 3. Percentages by which a law's weighted peaks exceed the optimum of n = 12.
struct LawComparisonRow {
    std::string name, key;
    std::optional<PeakFigures> printed;  ///< objective unused; jerk infinite where printed so
    std::optional<PeakFigures> exact;    ///< none where the catalogue has no such law; infinite jerk possible
    std::optional<double> loss_percent;  ///< none where infinite
};

/// Table 4, n = 10.
struct WeightEffectRow {
    double velocity = 0.0, acceleration = 0.0, jerk = 0.0;
    double printed_fourth_ordinate = 0.0;
    double printed_objective =
        0.0;                       ///< at the optimum n = 10 peaks of the printed points under these weights
    double fourth_ordinate = 0.0;  ///< of the proved optimum
    Solution optimum;
    LimitCurve limit;
};

struct ReferenceTable {
    std::vector<ConvergenceRow> convergence;
    std::vector<LawComparisonRow> laws;
    std::vector<WeightEffectRow> weights;
    LimitCurve limit;                 ///< for the paper's weights
    PeakFigures modified_sine_exact;  ///< with the paper's rounded references
    std::vector<std::string> notes;   ///< what differs from the paper and why
};

/// `finished` hears of each row's solve, for progress.
[[nodiscard]] ReferenceTable spline_versus_modified_sine(
    const SolveControl& control = {}, const std::function<void(const std::string&)>& finished = {});

/// The solves that are not proved optimal, in words: "n = 10 (failed: time_limit)".
[[nodiscard]] std::vector<std::string> unproved_rows(const ReferenceTable& table);

/// Tables 1 to 4 and Figs. 1 to 8 of the paper (T.-Y. Shon and M.-Y. Yang, "Synthesis of Optimum CAM Curve by
/// Cubic Spline", 1994), printed and ours. A fault for each row that is not proved optimal.
[[nodiscard]] PaperReport paper_004_report(const ReferenceTable& table);

/// The scene of one row: DRD, cubic, symmetric as the paper forces it, the paper's rounded references.
[[nodiscard]] Scene paper_scene(int segments, double velocity_weight, double acceleration_weight,
                                double jerk_weight);

}  // namespace camopt
