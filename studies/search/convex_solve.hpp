// SPDX-License-Identifier: MIT
// One convex problem, of a motion or of a machine: what a first attempt leaves without a proof is tried again
// with other steps, and then by another backend.
#pragma once

#include "solvers/exchange/exchange.hpp"

namespace camopt {

struct ConvexRun {
    ContinuousProblem& problem;
    const Solver& solver;
    std::string next_solver;  ///< tried if `solver` ends without a proof; empty: none
    JudgeOptions judge;
    const SolveControl& control;
};

/// Of the next solver.
struct NextSolver {
    std::optional<Reason> reason;  ///< why it was tried
    bool found = false;            ///< the motion is its
};

/// Whether one result is better than another: a motion than none, then what proves more, of what does not the
/// motion of the least objective. `gap`: objectives that differ by less are equal.
[[nodiscard]] bool is_better(const Certificate& one, const Certificate& two, double gap);

/// From the start of the problem. `exchange.backend.native`: of `solver`.
[[nodiscard]] ContinuousResult solve_convex(const ConvexRun& run, ExchangeOptions exchange, NextSolver& next);

}  // namespace camopt
