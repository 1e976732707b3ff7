// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: feasibility, and boundedness of the cost on the feasible set.
//
// Elastic problem:  min t   subject to   r_L − t <= C x <= r_U + t,  x_L <= x <= x_U,  t >= 0. It always has
// a solution. t* > 0 means infeasible, and its row multipliers are the proof: Cᵀλ + z = 0 and −Σ λ_i b_i − Σ
// z_j x_bound_j = t*, Σ |λ_i| = 1. Recession problem: min ∇fᵀd over directions d with |d| <= 1 that no bound,
// row or curvature limits; a negative optimum means unbounded.
#pragma once

#include "solvers/structured/interior_point.hpp"

namespace camopt::structured {

struct ElasticResult {
    Stop stop = Stop::breakdown;
    Eigen::VectorXd x;       ///< point of least common violation
    double violation = 0.0;  ///< t*
    Eigen::VectorXd lambda;
    double accuracy = infinity;  ///< Errors::worst() of the solution
    int iterations = 0;
};
[[nodiscard]] ElasticResult least_violation(const ConvexModel& model, const Eigen::VectorXd& start,
                                            const InteriorPointLimits& limits, const SolveControl& control);

struct RecessionResult {
    bool descends = false;  ///< a direction of unlimited descent exists (given a feasible point)
    Eigen::VectorXd direction;
    int iterations = 0;
};
/// Of a smooth cost only the gradient and Hessian at `point` are used.
[[nodiscard]] RecessionResult recession(const ConvexModel& model, const Eigen::VectorXd& point,
                                        const InteriorPointLimits& limits, const SolveControl& control);

}  // namespace camopt::structured
