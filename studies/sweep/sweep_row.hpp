// SPDX-License-Identifier: MIT
// What a sweep finds: one row a solve, and the table of them.
//
// Peaks are normalised as in core/motion.hpp, dimensions in m. What does not exist (the peaks of an
// infeasible row) is absent, never a NaN.
#pragma once

#include "scene/cost_table.hpp"
#include "solvers/certificate/certificate.hpp"

namespace camopt {

/// The figures of a motion that an objective can weigh, in the order of the columns.
using SweepFigure = CostFigure;
inline constexpr int sweep_figure_count = cost_figure_count;

/// Of a row with a follower train, at the worst speed of its range.
struct SweepTrain {
    std::optional<double> residual;              ///< lifts; none: nothing vibrates
    std::optional<double> dynamic_acceleration;  ///< normalised as A
    std::optional<double> contact_force;         ///< the least, N or N m; none: the cam guides it both ways
};

/// Of a feasible row with a cam: extremes of the delivered cam (CamSummary); none where it has no such
/// figure.
struct SweepCam {
    std::optional<double> pressure_angle;                 ///< the largest, rad
    std::optional<double> convex_radius, concave_radius;  ///< the least of the surface, m
};

/// Of a feasible row with a motor (DriveFigures): peaks in N m and rad/s.
struct SweepDrive {
    std::optional<double> torque, rms_torque, speed;
};

/// Of a feasible row whose spring is chosen with the motion: what was chosen, N and N/m, swinging N m and N
/// m/rad.
struct SweepSpring {
    std::optional<double> preload, spring_rate;
};

/// Of a row of a machine, rad/s: its speed, and the one at which it is proved that no motions exist.
struct SweepMachine {
    std::optional<double> speed, impossible_above;
};

/// Of a row whose scene seeks a number, in the unit of its key: what was found, and what is proved
/// impossible.
struct SweepSought {
    std::optional<double> value, impossible;
};

/// Of a row of a front (studies/pareto/pareto_front.hpp).
struct SweepFrontPlace {
    std::optional<double> point;                      ///< among the spaced points, from the first end
    std::optional<double> arc;                        ///< along the front from the first end, in the unit box
    std::optional<double> weighted;                   ///< the first goal where the scene's weights are kept
    std::optional<double> limit_first, limit_second;  ///< what no curve can pass; none: not known
    std::string end;                                  ///< name_of(FrontEnd)
};

struct SweepRow {
    int number = 0;                ///< from 0, by the plan
    std::vector<double> settings;  ///< of SweepColumns::keys, in the unit of each key; NaN: as in the scene
    Verdict verdict = Verdict::failed;
    std::string reason;  ///< why it is not better; empty where nothing is to be said
    std::optional<double> objective, lower_bound, gap, any_curve_limit;
    std::array<std::optional<double>, sweep_figure_count> figures{};  ///< by SweepFigure
    std::array<std::optional<double>, dimension_count> dimensions{};  ///< by DimensionIndex; variable ones
    SweepCam cam;
    SweepTrain train;
    SweepDrive drive;
    SweepSpring spring;
    SweepMachine machine;
    SweepSought sought;
    SweepFrontPlace front;
    /// Keys as written, in the scene's order; of a machine what stops it, the heaviest first.
    std::vector<std::string> active_limits;
    /// The row whose motion this one has too, proved without a solve; none: it was solved.
    std::optional<int> proved_from = {};
    int iterations = 0, exchange_rounds = 0;
    EvaluationCounts evaluations;
    double seconds_solve = 0.0, seconds_total = 0.0;
    bool on_front = false;  ///< set over all rows: mark_front (studies/pareto/sweep_front.hpp), or by a front

    [[nodiscard]] const std::optional<double>& figure(SweepFigure which) const {
        return figures[static_cast<std::size_t>(which)];
    }
    [[nodiscard]] const std::optional<double>& dimension(DimensionIndex which) const {
        return dimensions[static_cast<std::size_t>(which)];
    }
    /// It has a motion that satisfies every limit.
    [[nodiscard]] bool is_feasible() const { return has_feasible_motion(verdict); }
};

/// What the rows of one sweep have in common; known before anything is solved.
struct SweepColumns {
    std::vector<std::string> keys;           ///< varied, as the plan has them
    std::vector<DimensionIndex> dimensions;  ///< variable in at least one row
    bool train = false;                      ///< at least one row has a follower train
    bool machine = false;  ///< the rows are machines of several axes: no figures of a motion
    /// What the Pareto front weighs against one another: the names of all figures and dimensions that carry a
    /// weight > 0 in at least one row.
    std::vector<std::string> criteria;
    LengthUnit length_unit = LengthUnit::millimetre;  ///< in which people read the dimensions; files: mm
    bool drive = false;                               ///< at least one row has a motor
    bool spring = false;                              ///< the spring of at least one row is chosen
    bool sought = false;                              ///< at least one row seeks a number
    bool front = false;                               ///< the rows are those of a front

    /// The rows have different cams: a key of the cam varies, or one of its dimensions is variable.
    [[nodiscard]] bool cam() const {
        return !dimensions.empty() ||
               std::ranges::any_of(keys, [](const std::string& key) { return key.starts_with("cam."); });
    }
};

struct SweepTable {
    SweepColumns columns;
    std::vector<SweepRow> rows;  ///< by number, ascending
};

}  // namespace camopt
