// SPDX-License-Identifier: MIT
// What the scene demands of the motion itself, held against any motion, splines or not: caps on peaks, exact
// points, symmetry, ends without jerk.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

struct LimitRow;

/// A limit, an exact point or another condition of the scene, and what a motion makes of it.
struct LimitOutcome {
    ConstraintReport reached;
    bool kept = true;
    double excess = 0.0;  ///< how far beyond the limit, in its unit; <= 0 (to rounding) where kept
    double scale = 1.0;   ///< of the limited quantity (see active_limit), in its unit
    bool exact = false;   ///< a condition that holds or does not: a set point, symmetry, ends without jerk
};

struct MotionFigures {
    const MotionChain& motion;  ///< of a program: one part a segment
    const Peaks& peaks;         ///< normalised as the scene's
    const Peaks& motion_peaks;  ///< of the whole motion, in lifts and units of x
};

/// Exact points and symmetry are limits on the distance from them. Symmetry is looked at between the
/// breakpoints at samples.
[[nodiscard]] std::vector<LimitOutcome> motion_limits(const Scene& scene, const MotionFigures& figures);

/// Limits of one side and corridors (objectives/motion_bounds.hpp), one report for each key.
[[nodiscard]] std::vector<ConstraintReport> bound_reports(const Scene& scene, const Motion& motion);

/// A derivative that spline.rest makes 0 where the motion's splines meet rest.
struct RestFigure {
    int order = 3;
    double worst = 0.0, at = 0.0;  ///< its largest magnitude there, and x
    double size = 1.0;             ///< its largest magnitude along the splines, at least 1
};

/// One for each order from 3 to spline.rest.
[[nodiscard]] std::vector<RestFigure> rest_figures(const Scene& scene, const MotionChain& motion);

/// A limit that is passed by no more than the tolerance of the solve, of its scale, is kept. `cam`: null
/// where there is none.
[[nodiscard]] LimitOutcome outcome_of(const Scene& scene, const CamReport* cam,
                                      const ConstraintReport& reached);

// The size of the quantity that a limit holds, and with it when a limit is active. The only place that judges
// either: reports, audit and comparison ask here.
//
//     active:  slack <= active_limit · scale,   slack = reached − limit of a least value, limit − reached
//     else
//
// The scale comes from the quantity and not from the limit, which may be 0: of a radius of the cam its base
// radius, of an undercut margin 1, of a force on the cam the largest one that the motion reaches, of the
// force of an elastic train its springs at the lift; of everything else, whose limit is above 0, the larger
// of limit and reached value. A radius that the cam has nowhere is infinite: its limit is not active.

/// Of the scale. Solved limits are met to the tolerance of the solve, 1e-9 by default; what the tie-break
/// leaves of an active limit is below 1e-6.
inline constexpr double active_limit = 1e-6;

/// Of the quantity that the row limits, SI; 0 where limit and reached value are all there is to measure by.
/// `cam`: of the scene; null where there is none.
[[nodiscard]] double quantity_size(const Scene& scene, const CamReport* cam, const LimitRow& row);

/// In the unit of the report. `cam`: of the scene; null where there is none.
[[nodiscard]] double limit_scale(const Scene& scene, const CamReport* cam, const ConstraintReport& report);

/// How far the limit is passed, in the unit of the report; below 0 where it is satisfied.
[[nodiscard]] double limit_excess(const ConstraintReport& report);

/// A radius that the cam has nowhere: the limit is satisfied, there is no value and no cam angle.
[[nodiscard]] bool is_nowhere(const ConstraintReport& report);

/// Sets `active` of every constraint of a solution with its motion, cam and train.
void judge_activity(Solution& solution);

}  // namespace camopt
