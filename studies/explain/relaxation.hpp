// SPDX-License-Identifier: MIT
// For a scene without a motion: what would have to change.
//
//   more segments of the spline;
//   the least change of each limit and dimension alone, the others kept;
//   where no limit alone can give way far enough, the least common change of all limits.
//
// A cap on a peak of DRD and RR: the peak is minimized under the other limits. Everything else is searched by
// its value (value_search.hpp). Nothing is told that was not solved: each number, as it is rounded for
// people, was put into the scene, and a solve with it found a motion. All of it together ends at the
// control's deadline, each change within its share; one whose search does not end in time is named as such.
#pragma once

#include "studies/delivered/solution.hpp"
#include "studies/explain/relaxation_budget.hpp"

namespace camopt {

/// Fills relaxation and explanation of a solution that is infeasible or failed for want of a feasible point.
/// control.deadline: what the solve has left of solver.max_seconds.
void explain(Solution& solution, const SolveControl& control);

}  // namespace camopt
