// SPDX-License-Identifier: MIT
// The steps of a planned solve (planned_solve.cpp) besides the search from several starts (start_search.hpp).
#pragma once

#include "studies/search/planned_solve.hpp"

namespace camopt {

/// Of a proved optimum whose plan breaks ties: among the optima within the tolerance, the one of least mean
/// square jerk. On a linear program a small enough weight on the energy picks exactly that one; how small is
/// found by trying. (To demand "objective <= optimum" as a row instead leaves a feasible set without an
/// inside, on which an interior point loses its digits.) Leaves the result alone where nothing smoother is
/// found; false: where none was tried to the end. The grid of `problem` is refined.
bool break_tie(const PlannedRun& run, CamProblem& problem, ContinuousResult& result);

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

/// Whether the motion leaves the range of a stroke by more than the scene's tolerance.
[[nodiscard]] bool leaves_its_strokes(const Scene& scene, const MotionFamily& family,
                                      const MotionChain& motion);
[[nodiscard]] bool leaves_its_strokes(const Solution& solution);

/// With rules for every stroke of a scene whose objective is near one. Optimal within solver.gap of the least
/// bound of all cases, infeasible where every case is.
[[nodiscard]] Solution solve_held_strokes(const Scene& scene, const SolveControl& control);

/// Gives a solution the bound of a relaxation where that is the better one, and the verdict that follows.
void take_bound_of_relaxation(Solution& held, const Solution& relaxed);

// Scenes whose breakpoints are free: a search over breakpoints, then the ordinary solve on the best ones.
//
// Where the motion of least objective of all curves is one of these splines, its switching points are the
// breakpoints, and there is nothing to search. Else several starts, the scene's own breakpoints first; each
// goes downhill (free_knot_descent.hpp). What is delivered is the ordinary solution for the breakpoints
// found, never worse than that of the start. Its multipliers prove it for those breakpoints only. Over all
// breakpoints the lower bound for every curve is a bound: within `solver.gap` of it the verdict is optimal,
// else local.

[[nodiscard]] Solution solve_free_knots(const PlannedRun& run);

/// Breakpoints on which a spline of the scene reaches the lower bound for every curve: the switching points
/// of that curve and, in the longest pieces between them, as many more as the scene has. Empty where no curve
/// reaches it, more than peaks is limited, or the spline is too smooth or has too few segments.
[[nodiscard]] std::vector<double> limit_breakpoints(const Scene& scene, const Peaks& reference);

/// Where the best breakpoints make a motion that leaves its lift: the best one on them that does not.
[[nodiscard]] Solution solve_held_on_breakpoints(const Scene& scene, const Solution& first,
                                                 const SolveControl& control);

// Programs whose segments have a range for their angle: which angles, that still add up to the turn, are
// best?
//
// For given angles β the scene is an ordinary one, of least objective f(β). Boxes [l, u] of angles are
// bounded and split, the one of the least bound first, where a bound is known:
//
//   Each segment's y over its own part u = (θ − start) / β of the way. Where every spline rests at both of
//   its ends nothing but the limits in time knows β: |y^{(r)}(u)| lift (ω / β)^r <= cap, which a larger β
//   only loosens, and V, A, J are normalised by β. So f falls, or stays, where an angle grows, and on a box
//   f(β) >= f(u'), u' the largest angles in it that leave the others their least (they need not add up).
//
// Within `solver.gap` of the least bound the verdict is optimal (proof: boxes). Otherwise, and where no bound
// is known (cams with limits, joints at speed, set points in units), angle is passed from one segment to
// another by steps that shrink until none helps: local with two ranges, feasible with more.

/// Whether the least objective can only fall where an angle grows: boxes of angles can be bounded.
[[nodiscard]] bool bounds_by_angles(const Scene& scene);

/// Each set of angles is a scene without ranges, solved by its own plan; its angles need not add up to a
/// turn. The solution's scene has the angles that were found.
[[nodiscard]] Solution solve_free_angles(const Scene& scene, const SolvePlan& plan,
                                         const SolveControl& control);

}  // namespace camopt
