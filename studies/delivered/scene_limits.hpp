// SPDX-License-Identifier: MIT
// What the scene demands of the motion itself, held against any motion, splines or not: caps on peaks, exact
// points, symmetry, ends without jerk.
#pragma once

#include "studies/delivered/solution.hpp"

#include <utility>
#include <vector>

namespace camopt {

/// A limit, an exact point or another condition of the scene, and what a motion makes of it.
struct LimitOutcome {
    ConstraintReport reached;
    bool kept = true;
    double excess = 0.0;  ///< how far beyond the limit, in its unit; <= 0 (to rounding) where kept
    double scale = 1.0;   ///< of the limited quantity (limit_activity.hpp), in its unit
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

/// x and side of every place where a scene with spline.end_jerk wants y''' = 0: the ends, of a program where
/// a spline meets a dwell.
[[nodiscard]] std::vector<std::pair<double, Side>> quiet_places(const Scene& scene,
                                                                const MotionChain& motion);

/// A limit that is passed by no more than the tolerance of the solve, of its scale, is kept. `cam`: null
/// where there is none.
[[nodiscard]] LimitOutcome outcome_of(const Scene& scene, const CamReport* cam,
                                      const ConstraintReport& reached);

}  // namespace camopt
