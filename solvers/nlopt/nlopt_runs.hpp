// SPDX-License-Identifier: MIT
// Runs of one NLopt optimizer until nothing changes any more. Private to this folder (an NLopt type appears).
#pragma once

#include "solvers/backend_support.hpp"
#include "solvers/nlopt/nlopt_adapter.hpp"

#include <nlopt.h>

namespace camopt {

struct NloptOutcome {
    Termination termination;
    const char* word;
};
/// A positive code is not success: the limits on evaluations and time have such codes too.
[[nodiscard]] NloptOutcome outcome_of(nlopt_result status);

[[nodiscard]] bool is_finished(Termination termination);

/// Runs, and runs again from where that ended, until a run ends feasible and lowers the cost no more, or
/// `restarts` are used up. SLSQP needs it on degenerate linear programs, where it stops early or stalls with
/// a worn-out quasi-Newton matrix; so do MMA, CCSAQ and L-BFGS, which end with FAILURE where their dual or
/// their line search finds no progress and mostly go on from there. A FAILURE that changes nothing is
/// acceptable.
class NloptRuns {
 public:
    NloptRuns(nlopt_opt optimizer, NloptAdapter& adapter, SolveGuard& guard, const BackendOptions& options)
        : optimizer_(optimizer), adapter_(adapter), guard_(guard), options_(options) {}

    [[nodiscard]] BackendResult from(Eigen::VectorXd x, int restarts);

 private:
    NloptOutcome once(Eigen::VectorXd& x, double& cost);

    nlopt_opt optimizer_;
    NloptAdapter& adapter_;
    SolveGuard& guard_;
    const BackendOptions& options_;
};

}  // namespace camopt
