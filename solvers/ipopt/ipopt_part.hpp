// SPDX-License-Identifier: MIT
// The part "ipopt": what ipopt_solver.cpp asks of Ipopt. Internal.
#pragma once

#include "solvers/backend_support.hpp"

#include <mutex>

namespace camopt {

struct Linearity {
    bool equalities = true, inequalities = true;
};

[[nodiscard]] inline Linearity linearity_of(const NlpShape& shape) {
    Linearity linear;
    for (int row = 0; row < shape.constraints(); ++row) {
        if (shape.rows[row].linear) continue;
        (shape.g_lower[row] == shape.g_upper[row] ? linear.equalities : linear.inequalities) = false;
    }
    return linear;
}

struct IpoptPart {
    /// One for all camopts of the process that open this file. Recursive, because an evaluation may solve
    /// something with Ipopt.
    std::recursive_timed_mutex& (*turn)();
    /// One run of Ipopt, in its turn, with arguments that are checked.
    BackendResult (*run)(const Nlp& problem, const Eigen::VectorXd& start, const BackendOptions& options,
                         SolveGuard& guard, bool predictor_corrector);
};

}  // namespace camopt
