// SPDX-License-Identifier: MIT
// Scenes whose breakpoints are free: a search over breakpoints, then the ordinary solve on the best ones.
//
// Where the motion of least objective of all curves is one of these splines, its switching points are the
// breakpoints, and there is nothing to search. Else several starts, the scene's own breakpoints first; each
// goes downhill (free_knot_descent.hpp). What is delivered is the ordinary solution for the breakpoints
// found, never worse than that of the start. Its multipliers prove it for those breakpoints only. Over all
// breakpoints the lower bound for every curve is a bound: within `solver.gap` of it the verdict is optimal,
// else local.
#pragma once

#include "studies/search/planned_run.hpp"

namespace camopt {

/// solve: of the scene with given breakpoints.
[[nodiscard]] Solution solve_free_knots(const PlannedRun& run, const SolveScene& solve);

/// Breakpoints on which a spline of the scene reaches the lower bound for every curve: the switching points
/// of that curve and, in the longest pieces between them, as many more as the scene has. Empty where no curve
/// reaches it, more than peaks is limited, or the spline is too smooth or has too few segments.
[[nodiscard]] std::vector<double> limit_breakpoints(const Scene& scene, const Peaks& reference);

}  // namespace camopt
