// SPDX-License-Identifier: MIT
// One continuous problem, one backend, one judged answer: exchange, repair, proof, verdict.
#pragma once

#include "solvers/certificate.hpp"
#include "solvers/exchange.hpp"

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
    std::string proof_source;  ///< whose multipliers proved the bound
};

/// The verdict for a delivered point whose lower bound (if any) is already in the certificate.
void settle_verdict(Certificate& certificate, Termination termination, const JudgeOptions& options);

/// Runs the backend by exchange, pulls a slightly violating result back inside the limits, proves what can be
/// proved (the backend's multipliers, fitted ones, the structured solver's), and proves infeasibility on the
/// elastic problem.
[[nodiscard]] ContinuousResult solve_continuous(ContinuousProblem& problem, const Solver& solver,
                                                const ExchangeOptions& exchange, const JudgeOptions& judge,
                                                const SolveControl& control);

}  // namespace camopt
