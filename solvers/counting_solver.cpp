// SPDX-License-Identifier: MIT
#include "solvers/counting_solver.hpp"

namespace camopt {

BackendResult CountingSolver::minimize(const Nlp& problem, const Eigen::VectorXd& start,
                                       const BackendOptions& options, const SolveControl& control) const {
    const CountingNlp counted(problem, counts_);
    return solver_->minimize(counted, start, options, control);
}

}  // namespace camopt
