// SPDX-License-Identifier: MIT
// Breakpoints downhill. For fixed breakpoints t the best motion is a solve of its own, of value φ(t), and its
// multipliers give the slope of φ exactly. Each step solves
//
//   min ∇fᵀd + ½ d_tᵀ B d_t   over rows linearized at the best motion, |d_t| <= radius,
//
// B a damped BFGS matrix of the Lagrangian's slope by t, then the best motion for t + d_t. It is taken where
// φ falls, so every iterate satisfies all limits and none is worse than the start.
// Source: Nocedal, Wright, Numerical Optimization (2006), chapter 18, with the fixed solve as restoration.
#pragma once

#include "objectives/free_knots/free_knot_problem.hpp"
#include "solvers/exchange/exchange.hpp"

namespace camopt {

struct FreeKnotOptions {
    ExchangeOptions exchange;   ///< of the solves with fixed breakpoints, and the time of all
    double tolerance = 1e-9;    ///< relative gain below which the descent ends
    double enough = -infinity;  ///< an objective that cannot be bettered: stop there
    int most_steps = 150;
};

/// A motion and what its breakpoints could still gain.
struct FreeKnotResult {
    Candidate found;                 ///< x of the FreeKnotProblem, completed
    double stationarity = infinity;  ///< least gain a step still promises, relative to the objective
    int steps = 0, rounds = 0;       ///< steps; grids solved
    int iterations = 0;              ///< of the solver
    Termination termination = Termination::not_run;
};

/// From `start`, a point of `problem`. `problem` is refined on the way.
[[nodiscard]] FreeKnotResult descend(FreeKnotProblem& problem, const Eigen::VectorXd& start,
                                     const Solver& solver, const FreeKnotOptions& options,
                                     const SolveControl& control);

}  // namespace camopt
