// SPDX-License-Identifier: MIT
// Every law of the catalogue on one scene, beside the optimum: what each loses, which limits it breaks, and
// how large its cam would have to be.
//
// A law stands where the scene's spline stands (law_motion.hpp). Objective, peaks and limits are the scene's
// own; where a dimension of the cam is variable the laws get the optimum's (without an optimum the middle of
// its range). Units as in Solution; infinite peaks are infinite.
#pragma once

#include "studies/delivered/scene_limits.hpp"

namespace camopt {

// The smallest base radius at which a given motion satisfies every limit of the scene's cam, the other
// dimensions as they are.
//
// The limits are the rules the optimizer keeps (objectives/rules/cam_limits.hpp), judged by their continuous
// maxima along the motion. From the smallest cam that can be built upwards, radii are tried in steps (ten a
// decade of the distance from that smallest; where the mechanism allows no larger ones than some radius,
// 1/400 of what it allows); between the first that satisfies all limits and its forerunner the edge is
// searched (studies/least/feasible_edge.hpp). A radius that helps only within one step, between two that do
// not, may be missed.

struct NeededBase {
    std::optional<double> radius;  ///< m; none: no base radius helps
    std::string broken;            ///< then a limit that stays broken: its key, or why no cam can be built
};

/// cam: that of the scene. Only the steps depend on its base radius. Throws InputError for a cam whose
/// base radius is no dimension (CamMechanism::base_radius_index), and for a limit the follower cannot have.
[[nodiscard]] NeededBase needed_base(const Scene& scene, const DrivenMechanism& cam, const Motion& motion);

/// ComparisonRow::key of the motion of a given cam.
inline constexpr const char* given_row_key = "given";

struct ComparisonRow {
    std::string key;     ///< of the law; empty: the optimum; given_row_key: the given cam
    std::string title;   ///< for people
    std::string misfit;  ///< why the law cannot make this motion at all; then nothing below is set
    std::shared_ptr<const MotionChain> motion;
    Peaks peaks;
    Peaks motion_peaks;      ///< of the whole motion in lifts and units of x: what physical peaks come from
    double objective = 0.0;  ///< infinite where an infinite peak has a weight
    /// Against the optimum. None where infinite, without an optimum, of a law that misses a condition of the
    /// motion (another motion is no loss), and where a broken limit alone makes it better.
    std::optional<double> loss_percent;
    std::vector<LimitOutcome> limits;   ///< the same ones, in the same order, in every row
    bool feasible = false;              ///< every limit is satisfied
    std::optional<DriveFigures> drive;  ///< where the scene has a motor
    std::optional<NeededBase> base;     ///< where the scene limits a cam whose base radius is a dimension

    [[nodiscard]] bool is_optimum() const { return key.empty(); }
    [[nodiscard]] bool is_law() const { return !is_optimum() && key != given_row_key; }
};

struct Comparison {
    Solution optimum;
    std::optional<DrivenMechanism> cam;  ///< that the laws were judged with; none: the scene has no cam
    /// By objective: first what satisfies every limit, then what breaks one or cannot touch its cam, last the
    /// laws that do not fit. The optimum is among them where there is a motion.
    std::vector<ComparisonRow> rows;
};

/// Throws as solve() does. A failed or infeasible optimum is a verdict in Comparison::optimum; its relaxation
/// is not looked for.
[[nodiscard]] Comparison compare(const Scene& scene, const SolveControl& control = {});

/// No set point or other exact condition of the scene is missed.
[[nodiscard]] bool meets_conditions(const ComparisonRow& row);

/// One law in the place of a motion that is delivered already: nothing is solved. Its limits are judged with
/// the delivered cam. Throws InputError for an unknown law and for a solution without a motion.
[[nodiscard]] ComparisonRow compare_law(const Solution& solution, const std::string& law);

}  // namespace camopt
