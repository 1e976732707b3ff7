// SPDX-License-Identifier: MIT
// Solves one continuous problem with one backend: exchange, repair, proof, verdict.
#pragma once

#include "solvers/certificate/certificate.hpp"
#include "solvers/exchange/exchange.hpp"

namespace camopt {

struct JudgeOptions {
    double tolerance = 1e-9;     ///< a violation below this, relative to its scale, counts as satisfied
    double gap = 1e-7;           ///< proved relative gap below which the verdict is optimal
    double stationarity = 1e-6;  ///< residual below which a feasible point is called local; sizes are O(1)
};

struct ContinuousResult {
    Eigen::VectorXd x;  ///< completed; empty if nothing is delivered
    Certificate certificate;
    ExchangeResult exchange;
    Candidate inside;          ///< a feasible point (if there is one), towards which results are pulled
    std::string proof_source;  ///< whose multipliers proved the bound
};

/// If the current bound exceeds the objective of the delivered point (the limits are infeasible to within
/// round-off), the proof is replaced by that of the limits relaxed by the tolerance, or removed if there is
/// none. Afterwards no bound exceeds the objective. `problem`: that of the bound.
void settle_passed_bound(ContinuousResult& result, const ContinuousProblem& problem,
                         const ExchangeOptions& exchange, const JudgeOptions& judge,
                         const SolveControl& control);

/// The verdict for a delivered point whose lower bound (if any) is already in the certificate.
void settle_verdict(Certificate& certificate, Termination termination, const JudgeOptions& options);

/// Repairs a small violation left by a backend: the point moves towards a feasible one as far as its
/// violation requires (convex problems). Unchanged if there is none or nothing to repair.
[[nodiscard]] Candidate pulled_inside(const ContinuousProblem& problem, const Candidate& point,
                                      const Candidate& inside);

/// Searches for a feasible point first, and if there is none proves infeasibility on the elastic problem, for
/// any backend. Then runs the backend by exchange from that point, repairs its result, and proves a bound:
/// with the backend's multipliers, fitted ones, or the structured solver's. All of it takes
/// exchange.backend.max_seconds at most. Interrupted before it searched: no x.
[[nodiscard]] ContinuousResult solve_continuous(ContinuousProblem& problem, const Solver& solver,
                                                const ExchangeOptions& exchange, const JudgeOptions& judge,
                                                const SolveControl& control);

}  // namespace camopt
