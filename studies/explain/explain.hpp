// SPDX-License-Identifier: MIT
// For a scene without a motion: what would have to change.
//
//   set points without which there is a motion, and the least change of one of their numbers;
//   the least change of each angle, dimension, limit, … alone, the others kept; more segments of the spline;
//   where no limit alone can give way far enough, the least common change of all limits.
//
// The most useful come first (Usefulness), and the search ends with solver.explain_changes useful ones or
// after solver.explain_seconds. Values are searched by studies/least/feasible_edge.hpp. Nothing is reported
// that was not solved: each number, as it is rounded for people, was put into the scene, and a solve with it
// found a motion. Each change ends within its share of the time; one whose search does not is named as such.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// Fills relaxation and explanation of a solution that is infeasible or failed for want of a feasible point.
/// control.deadline: what the solve has left of solver.max_seconds.
void explain(Solution& solution, const SolveControl& control);

}  // namespace camopt
