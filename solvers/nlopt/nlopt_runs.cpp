// SPDX-License-Identifier: MIT
#include "solvers/nlopt/nlopt_runs.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string_view>

namespace camopt {

NloptOutcome outcome_of(nlopt_result status) {
    using enum Termination;
    switch (status) {
        case NLOPT_SUCCESS:
            return {converged, "SUCCESS"};
        case NLOPT_FTOL_REACHED:
            return {converged, "FTOL_REACHED"};
        case NLOPT_XTOL_REACHED:
            return {converged, "XTOL_REACHED"};
        case NLOPT_STOPVAL_REACHED:
            return {unbounded, "STOPVAL_REACHED"};
        case NLOPT_MAXEVAL_REACHED:
            return {iteration_limit, "MAXEVAL_REACHED"};
        case NLOPT_MAXTIME_REACHED:
            return {time_limit, "MAXTIME_REACHED"};
        case NLOPT_FAILURE:
            return {numerical_failure, "FAILURE"};
        case NLOPT_INVALID_ARGS:
            return {unsupported, "INVALID_ARGS"};
        case NLOPT_OUT_OF_MEMORY:
            return {numerical_failure, "OUT_OF_MEMORY"};
        case NLOPT_ROUNDOFF_LIMITED:
            return {acceptable, "ROUNDOFF_LIMITED"};
        case NLOPT_FORCED_STOP:
            return {interrupted, "FORCED_STOP"};
        default:
            return {numerical_failure, "unknown to camopt"};  // a code of a later NLopt
    }
}

namespace {

/// What a line search says, or the dual inside MMA and CCSAQ.
bool found_no_progress(const NloptOutcome& outcome) {
    return outcome.word == std::string_view("FAILURE");
}

}  // namespace

bool is_finished(Termination termination) {
    return termination == Termination::converged || termination == Termination::acceptable;
}

BackendResult NloptRuns::from(Eigen::VectorXd x, int restarts) {
    const double feasible = 10.0 * number_or(options_, "constraint_tolerance", options_.tolerance);
    BackendResult result;
    const Eigen::VectorXd start = x;
    double best = infinity, violation = infinity;
    for (int run = 0; run <= restarts; ++run) {
        double cost = 0.0;
        const NloptOutcome outcome = once(x, cost);
        result.termination = outcome.termination;
        result.native_status = outcome.word;
        const bool failed = found_no_progress(outcome) && !guard_.stopping();
        if (!is_finished(outcome.termination) && !failed) break;
        violation = adapter_.violation(x);
        const bool settled =
            std::abs(best - cost) <= 0.1 * options_.tolerance * std::max(1.0, std::abs(cost));
        best = cost;
        if (settled && run > 0 && violation <= feasible) {
            // No way down from here, twice in a row: what a line search says at an optimum.
            if (failed && x != start) result.termination = Termination::acceptable;
            break;
        }
    }
    if (is_finished(result.termination) && violation > feasible) {
        result.termination = Termination::numerical_failure;
        result.native_status += fmt::format(" with violation {:.2g}", violation);
    }
    result.x = std::move(x);
    result.iterations = adapter_.evaluations();
    return result;
}

NloptOutcome NloptRuns::once(Eigen::VectorXd& x, double& cost) {
    const int left = options_.max_iterations - adapter_.evaluations();
    if (left < 1) return {Termination::iteration_limit, "MAXEVAL_REACHED"};
    nlopt_set_maxeval(optimizer_, left);
    nlopt_set_maxtime(optimizer_, guard_.seconds_left());
    Eigen::VectorXd end = x;
    const NloptOutcome outcome = outcome_of(nlopt_optimize(optimizer_, end.data(), &cost));
    if (outcome.termination == Termination::time_limit) (void)guard_.must_stop();  // NLopt's watch, and ours
    if (end.allFinite()) x = end;
    return outcome;
}

}  // namespace camopt
