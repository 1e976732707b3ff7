// SPDX-License-Identifier: MIT
// One continuous problem, one backend, one judged answer: exchange, repair, proof, verdict.
#pragma once

#include "solvers/certificate/certificate.hpp"
#include "solvers/exchange/exchange.hpp"

namespace camopt {

struct JudgeOptions {
    double tolerance = 1e-9;     ///< a limit violated by less, relative to its scale, is kept
    double gap = 1e-7;           ///< proved relative gap below which the verdict is optimal
    double stationarity = 1e-6;  ///< residual below which a feasible point is called local; sizes are O(1)
};

struct ContinuousResult {
    Eigen::VectorXd x;  ///< completed; empty where there is nothing to deliver
    Certificate certificate;
    ExchangeResult exchange;
    Candidate inside;  ///< a point within the limits (where there is one), towards which results are pulled
    std::string proof_source;  ///< whose multipliers proved the bound
};

/// Where the bound at hand passes the objective of the delivered point (the limits lie within rounding of
/// infeasible), the proof becomes that of the limits relaxed by the tolerance; where there is none, nothing
/// is left of it. Afterwards no bound passes the objective. `problem`: what the bound is of.
void settle_passed_bound(ContinuousResult& result, const ContinuousProblem& problem,
                         const ExchangeOptions& exchange, const JudgeOptions& judge,
                         const SolveControl& control);

/// The verdict for a delivered point whose lower bound (if any) is already in the certificate.
void settle_verdict(Certificate& certificate, Termination termination, const JudgeOptions& options);

/// A small violation left by a backend is repaired, not reported away: the point moves towards one inside the
/// limits just as far as its violation asks for (convex problems). Unchanged where there is none or nothing
/// to repair.
[[nodiscard]] Candidate pulled_inside(const ContinuousProblem& problem, const Candidate& point,
                                      const Candidate& inside);

/// Looks for a point within the limits first, and where there is none proves that on the elastic problem,
/// whichever backend was to run. Then runs the backend by exchange from that point, repairs its result, and
/// proves what can be proved: with the backend's multipliers, fitted ones, or the structured solver's. All of
/// it takes exchange.backend.max_seconds at most. Interrupted before it searched: no x.
[[nodiscard]] ContinuousResult solve_continuous(ContinuousProblem& problem, const Solver& solver,
                                                const ExchangeOptions& exchange, const JudgeOptions& judge,
                                                const SolveControl& control);

}  // namespace camopt
