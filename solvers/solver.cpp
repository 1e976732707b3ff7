// SPDX-License-Identifier: MIT
#include "solvers/solver.hpp"

#include "core/errors.hpp"

#include <fmt/core.h>

#include <cmath>

namespace camopt {

const char* name_of(Termination value) {
    switch (value) {
        case Termination::not_run:
            return "not_run";
        case Termination::converged:
            return "converged";
        case Termination::acceptable:
            return "acceptable";
        case Termination::infeasible:
            return "infeasible";
        case Termination::unbounded:
            return "unbounded";
        case Termination::iteration_limit:
            return "iteration_limit";
        case Termination::time_limit:
            return "time_limit";
        case Termination::interrupted:
            return "interrupted";
        case Termination::numerical_failure:
            return "numerical_failure";
        case Termination::evaluation_error:
            return "evaluation_error";
        case Termination::unsupported:
            return "unsupported";
    }
    return "unknown";
}

void BackendOptions::validate() const {
    if (!(tolerance > 0.0 && tolerance < 1.0))
        throw InputError(
            fmt::format("solver option 'tolerance': found {}, allowed is a number in (0, 1)", tolerance));
    if (max_iterations < 1)
        throw InputError(fmt::format("solver option 'max_iterations': found {}, allowed is an integer >= 1",
                                     max_iterations));
    if (!(max_seconds > 0.0 && std::isfinite(max_seconds)))
        throw InputError(fmt::format("solver option 'max_seconds': found {}, allowed is a finite number > 0",
                                     max_seconds));
}

BackendResult CountingSolver::minimize(const Nlp& problem, const Eigen::VectorXd& start,
                                       const BackendOptions& options, const SolveControl& control) const {
    const CountingNlp counted(problem, counts_);
    return solver_->minimize(counted, start, options, control);
}

}  // namespace camopt
