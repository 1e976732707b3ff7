// SPDX-License-Identifier: MIT
// motion.within_lift and motion.monotone: scenes whose best motion leaves the range of a stroke.
//
// A scene is solved without the rules of its strokes first (objectives/strokes.hpp). Usually that motion
// stays within their range, and is the optimum. Else the scene is solved with the rules; the bound of the
// first solve, of a relaxation, holds for it too. Where a relaxation without the rules
// that are not convex settles a scene, its motion is checked before the tie is broken.
//
// The rules depend on whether a stroke rises or falls, which a free displacement leaves open. Such strokes
// are not held at first. Where the motion leaves the range of one for the direction that it takes, the stroke
// that does so most is split into two cases, it rises or it falls; together they hold everything.
#pragma once

#include "studies/search/planned_run.hpp"

namespace camopt {

/// With rules for every stroke, in the units of the posed scene. Optimal within solver.gap of the least
/// bound of all cases, infeasible where every case is.
[[nodiscard]] Solution solve_stroke_directions(const Scene& scene, const SolveControl& control);

/// Gives a solution the bound of a relaxation where that is the better one, and the verdict that follows.
void take_bound_of_relaxation(Solution& held, const Solution& relaxed);

}  // namespace camopt
