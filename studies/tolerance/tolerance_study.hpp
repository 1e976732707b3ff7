// SPDX-License-Identifier: MIT
// What the tolerances of a scene cost: the price against the same scene without them, which of them decides
// each limit, what half of each would bring, and how many segments of a spline are worth making.
//
//     price          (f − f₀) / f₀, f₀ the objective of the scene without tolerances
//     halved         (f − f_k) / f, f_k that with tolerance k halved
//     segments       the least n with f₀(n) − f₀(n of the scene) <= f − f₀: finer splines gain less than the
//                    tolerances cost
#pragma once

#include "solvers/solver.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// Fills Solution::tolerance: a solve for the price, one for each tolerance, a few for the segments, as far
/// as the time lasts. Nothing of a solution without a motion.
void report_tolerance(Solution& solution, const SolveControl& control);

}  // namespace camopt
