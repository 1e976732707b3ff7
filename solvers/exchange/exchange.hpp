// SPDX-License-Identifier: MIT
// Exchange algorithm of semi-infinite programming: solve on a grid, find the continuous maxima of violation,
// add their rows, solve again.
//
// Ends when the violation between samples is below the tolerance: the true objective of the curve exceeds the
// grid's by less, and no limit is violated by more, than `tolerance`. The grid is a relaxation, so its
// optimum remains a bound.
#pragma once

#include "core/continuous_problem.hpp"
#include "solvers/solver.hpp"

namespace camopt {

struct ExchangeOptions {
    BackendOptions backend;
    double tolerance = 1e-9;  ///< relative, of objective and limits between the samples; > 0
    int most_rounds = 60;     ///< rounds are few; this only ends a backend that does not converge
};

/// The best point found, feasible ones first.
struct Candidate {
    Eigen::VectorXd x;            ///< completed: peaks true, equalities to round-off
    double objective = infinity;  ///< true
    double violation = infinity;  ///< worst continuous violation of a limit, relative; <= 0 is satisfied
};

struct ExchangeResult {
    Candidate best;      ///< none if it was interrupted before a first iteration
    Candidate latest;    ///< result of the last round: better than `best` once a small violation is repaired
    BackendResult last;  ///< of the last round; its multipliers belong to the final grid where `converged`
    Termination termination = Termination::not_run;
    bool converged = false;  ///< the exchange itself converged
    bool known = false;      ///< it ended near a minimum known to SolveControl::known
    int rounds = 0;
    int iterations = 0;  ///< summed over the rounds
};

/// By a time limit or the user.
[[nodiscard]] bool was_stopped(Termination termination);

/// Completes and verifies x.
[[nodiscard]] Candidate judged(const ContinuousProblem& problem, const Eigen::VectorXd& x);

/// Whether a candidate beats another: feasible (to `tolerance`) before infeasible, then objective, then
/// violation.
[[nodiscard]] bool is_better(const Candidate& left, const Candidate& right, double tolerance);

/// options.backend.max_seconds is the time of all rounds together.
[[nodiscard]] ExchangeResult minimize_by_exchange(ContinuousProblem& problem, const Solver& solver,
                                                  const Eigen::VectorXd& start,
                                                  const ExchangeOptions& options,
                                                  const SolveControl& control);
/// The same from a point that is verified already.
[[nodiscard]] ExchangeResult minimize_by_exchange(ContinuousProblem& problem, const Solver& solver,
                                                  const Candidate& start, const ExchangeOptions& options,
                                                  const SolveControl& control);

}  // namespace camopt
