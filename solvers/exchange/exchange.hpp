// SPDX-License-Identifier: MIT
// Solve on a grid, find the true continuous maxima of violation, add their rows, solve again.
//
// Ends when what the grid does not see is below the tolerance: the true objective of the curve exceeds the
// grid's by less, and no limit is violated by more, than `tolerance`. The grid is a relaxation, so its
// optimum stays a bound.
#pragma once

#include "core/continuous_problem.hpp"
#include "solvers/solver.hpp"

namespace camopt {

struct ExchangeOptions {
    BackendOptions backend;
    double tolerance = 1e-9;  ///< relative, of objective and limits between the samples; > 0
    int most_rounds = 60;     ///< rounds are few; this only ends a backend that never settles
};

/// The best point found, feasible ones first.
struct Candidate {
    Eigen::VectorXd x;            ///< completed: peaks true, equalities to round-off
    double objective = infinity;  ///< true
    double violation = infinity;  ///< worst continuous violation of a limit, relative; <= 0 is kept
};

struct ExchangeResult {
    Candidate best;      ///< none where it was interrupted before a first iteration
    Candidate latest;    ///< what the last round found: better than `best` once a small violation is repaired
    BackendResult last;  ///< of the last round; its multipliers belong to the final grid where `converged`
    Termination termination = Termination::not_run;
    bool converged = false;  ///< the exchange itself ended as it should
    bool known = false;      ///< it ended beside a minimum that SolveControl::known knows
    int rounds = 0;
    int iterations = 0;  ///< summed over the rounds
};

/// By a limit on time or by the user, not by an end of its own.
[[nodiscard]] bool was_stopped(Termination termination);

/// Completes x and judges it.
[[nodiscard]] Candidate judged(const ContinuousProblem& problem, const Eigen::VectorXd& x);

/// Whether a candidate beats another: feasible (to `tolerance`) before infeasible, then objective, then
/// violation.
[[nodiscard]] bool is_better(const Candidate& left, const Candidate& right, double tolerance);

/// options.backend.max_seconds is the time of all rounds together.
[[nodiscard]] ExchangeResult minimize_by_exchange(ContinuousProblem& problem, const Solver& solver,
                                                  const Eigen::VectorXd& start,
                                                  const ExchangeOptions& options,
                                                  const SolveControl& control);
/// The same from a point that is judged already.
[[nodiscard]] ExchangeResult minimize_by_exchange(ContinuousProblem& problem, const Solver& solver,
                                                  const Candidate& start, const ExchangeOptions& options,
                                                  const SolveControl& control);

}  // namespace camopt
