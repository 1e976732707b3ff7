// SPDX-License-Identifier: MIT
// Breakpoints downhill. For fixed breakpoints t the best motion is a solve of its own, of value φ(t). Each
// step solves
//
//   min ∇fᵀd + ½ d_xᵀ H d_x + ½ d_tᵀ B d_t   over rows linearized at the best motion x, |d_t| <= radius,
//
// H the Lagrangian's Hessian by x where the problem is convex (of the cost alone where it is not), B a damped
// BFGS matrix of its slope by t, then the best motion for t + d_t. It is taken where φ falls, so every
// iterate satisfies all limits and none is worse than the start.
//
// How rows and cost change with t is a difference of two grids: that of the scene on t, and that of the scene
// on breakpoints of which one is moved by 1e-6 of the mean segment, with the same motion and every sample at
// the same part of its piece. So any scene has free breakpoints, and no rule knows of them.
// Source: Nocedal, Wright, Numerical Optimization (2006), chapter 18, with the fixed solve as restoration.
#pragma once

#include "solvers/exchange/exchange.hpp"
#include "studies/search/moving_breakpoints.hpp"

namespace camopt {

struct FreeKnotOptions {
    ExchangeOptions exchange;   ///< of the solves with fixed breakpoints, and the time of all
    double tolerance = 1e-9;    ///< relative gain below which the descent ends
    double enough = -infinity;  ///< an objective that cannot be bettered: stop there
    int most_steps = 150;
};

/// A motion and what its breakpoints could still gain.
struct FreeKnotResult {
    Candidate found;
    std::shared_ptr<const CamProblem> problem;  ///< of `found`
    std::vector<double> breakpoints;
    double stationarity = infinity;  ///< least gain a step still promises, relative to the objective
    int steps = 0, rounds = 0;       ///< steps; grids solved
    int iterations = 0;              ///< of the solver
    Termination termination = Termination::not_run;
};

/// From `start`, a motion on the first breakpoints (null: the smoothest).
[[nodiscard]] FreeKnotResult descend(const MovingBreakpoints& breakpoints, const MotionChain* start,
                                     const Solver& solver, const FreeKnotOptions& options,
                                     const SolveControl& control);

}  // namespace camopt
