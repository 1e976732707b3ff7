// SPDX-License-Identifier: MIT
// A lower bound for motions that keep the limits to within a tolerance.
//
// A delivered point may use the tolerance of its limits. Where the limits leave no room (they lie within
// rounding of infeasible) that is all there is to use: the multipliers of the limits grow without end, and a
// bound for the limits exactly as written passes the objective of the point, or is infinite. The bound that
// says something of the point is that of the problem in which it lies: each limit moved out by `slack` times
// its scale. It is at or below the optimum of the limits as written too, so it is a bound for these as well,
// only a weaker one.
#pragma once

#include "core/continuous_problem.hpp"
#include "solvers/certificate/certificate.hpp"
#include "solvers/solver.hpp"

#include <optional>

namespace camopt {

/// The point of a problem that is spoken of: f(x) and how far it is outside, relative to each limit's scale.
struct JudgedPoint {
    const Eigen::VectorXd& x;
    double objective = infinity;
    double slack = 0.0;  ///< >= its violation
};

/// A proof that no point which keeps the limits to within `slack` has less than proof.bound, which is at most
/// the objective (to rounding). On the problem's present grid, by the structured solver; convex problems
/// only. None where no finite bound is found.
[[nodiscard]] std::optional<DualityProof> relaxed_proof(const ContinuousProblem& problem,
                                                        const JudgedPoint& point,
                                                        const BackendOptions& options,
                                                        const SolveControl& control);

}  // namespace camopt
