// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: sequential quadratic programming (S l1 QP with a trust region) for
// problems with nonlinear rows, or not known to be convex.
//
// Each pass linearizes the nonlinear rows at the current point x and solves, by the interior point for linear
// rows,   min ∇fᵀd + ½ dᵀHd + ν t   over steps d in a trust region, with linear rows enforced and nonlinear
// ones relaxed by t w_i (step problem of linearized_problem.hpp; t is omitted once the rows are consistent).
// H is the Lagrangian's Hessian, convexified. The merit function is f + ν max_i violation_i / w_i; where the
// curvature of the rows spoils a good step, they are linearized again with their values at its end
// (second-order correction). Convex: tangents are cuts, so contradicting tangents prove infeasibility.
// Sources: Fletcher, Practical Methods of Optimization (1987), section 14.4 (S l1 QP); Conn, Gould, Toint,
// Trust-Region Methods (2000), chapter 15.
#pragma once

#include "solvers/solver.hpp"
#include "solvers/structured/interior_point.hpp"
#include "solvers/structured/structured_solver.hpp"

namespace camopt::structured {

[[nodiscard]] BackendResult sequential_minimize(const Nlp& problem, const Eigen::VectorXd& start,
                                                const BackendOptions& options, const SolveControl& control);

// Internal to solvers/structured/: converts the options of a caller for the interior point.

/// The seconds count from now. Aims at a tenth of the tolerance, as a margin.
[[nodiscard]] InteriorPointLimits interior_point_limits(const BackendOptions& options,
                                                        const StructuredOptions& own,
                                                        const SolveControl& control);

}  // namespace camopt::structured
