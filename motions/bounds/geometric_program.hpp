// SPDX-License-Identifier: MIT
// Small geometric programs, solved to rounding accuracy.
//
//   min p_0(z)  subject to  p_i(z) <= 1,  z > 0,   p(z) = Σ_k coefficient_k Π_j z_j^exponent_kj,  coefficient
//   > 0
//
// With u = log z each log p is a convex log-sum-exp, so the one local minimum is global. Solved by a
// primal-dual interior point with explicit slacks (log p_i(u) + slack_i = 0), from a strictly feasible point
// that a first phase of the same kind finds (min t: p_i(z) <= t). Meant for a handful of variables: dense. No
// units. Errors: broken input (a coefficient that is not positive and finite, exponents of another number
// than the variables, no objective or no constraint) throws ModelError; what the numbers say is a status,
// never a NaN. Source: S. Boyd, L. Vandenberghe, Convex Optimization (2004), sections 4.5 and 11.7.
#pragma once

#include "core/base/standard.hpp"

#include <Eigen/Core>

namespace camopt {

struct Monomial {
    double coefficient = 1.0;
    std::vector<double> exponents;
};

using Posynomial = std::vector<Monomial>;

struct GeometricProgram {
    int variables = 0;
    Posynomial objective;
    std::vector<Posynomial> constraints;
};

enum class GeometricProgramStatus {
    optimal,        ///< the conditions of optimality hold to rounding
    infeasible,     ///< no z satisfies the constraints: the least common factor needed is above 1
    not_converged,  ///< neither could be established
};

struct GeometricProgramResult {
    GeometricProgramStatus status = GeometricProgramStatus::not_converged;
    Eigen::VectorXd variables;    ///< z, empty unless optimal
    Eigen::VectorXd multipliers;  ///< >= 0, of log p_i <= 0 for the objective log p_0; empty unless optimal
    double objective = 0.0;       ///< p_0(z), 0 unless optimal
    int iterations = 0;           ///< Newton steps of both phases
};

[[nodiscard]] GeometricProgramResult solve(const GeometricProgram& program);

}  // namespace camopt
