// SPDX-License-Identifier: MIT
// Scenes whose breakpoints are free: a search over breakpoints, then the ordinary solve on the best ones.
//
// Several starts, the scene's own breakpoints first; each goes downhill (free_knot_descent.hpp). What is
// delivered is the ordinary solution for the breakpoints found, never worse than that of the start. Its
// multipliers prove it for those breakpoints only. Over all breakpoints the lower bound for every curve is a
// bound: within `solver.gap` of it the verdict is optimal, else local.
#pragma once

#include "studies/search/planned_solve.hpp"

namespace camopt {

[[nodiscard]] Solution solve_free_knots(const PlannedRun& run);

/// Where the best breakpoints make a motion that leaves its lift: the best one on them that does not.
[[nodiscard]] Solution solve_held_on_breakpoints(const Scene& scene, const Solution& first,
                                                 const SolveControl& control);

}  // namespace camopt
