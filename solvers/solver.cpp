// SPDX-License-Identifier: MIT
#include "solvers/solver.hpp"

#include "core/errors.hpp"
#include "core/word_of.hpp"

#include <fmt/core.h>

namespace camopt {

const char* name_of(Termination value) {
    return word_of<Termination::unsupported>(
        value, {"not_run", "converged", "acceptable", "infeasible", "unbounded", "iteration_limit",
                "time_limit", "interrupted", "numerical_failure", "evaluation_error", "unsupported"});
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
