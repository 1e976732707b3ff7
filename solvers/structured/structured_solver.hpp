// SPDX-License-Identifier: MIT
// camopt's own solver; needs nothing but Eigen.
//
//     min f(x)   subject to   x_L <= x <= x_U,   g_L <= g(x) <= g_U,   all twice differentiable
//
// Convex with every row linear (by shape()): one interior point. Everything else: a sequence of such problems
// around the newest point (sequential_solver.hpp); what it finds is a local optimum, a global one where
// shape().convex. Bounds may be equal (fixed variables, equalities), one-sided or absent; redundant
// consistent rows do no harm. The cost is evaluated only at points between the bounds of x, strictly so with
// the interior point alone (where f is not quadratic), and rows only where the linear ones hold, the
// start apart.
//
// Linear rows, convex:
// converged: primal, dual and gap errors of the scaled problem are <= options.tolerance (it aims at a tenth
// of it); acceptable: <= 100 times that. Both multipliers are always given. infeasible: row_multipliers λ and
// bound_multipliers z are a Farkas ray instead,
//     Jᵀλ + z = 0   and   −Σ λ_i b_i − Σ z_j x_bound_j = 1,
// where b_i = g_U − g_0 for λ_i > 0 and g_L − g_0 for λ_i < 0, x_bound_j likewise; x is then the point of
// least common violation. The multipliers are absent where the bounds of one row or variable cross.
// unbounded: x is the last point, native_status says along what was found.
//
// Otherwise `iterations` counts the linearizations. converged: violations relative to RowKind::scale and the
// gain that the model of the last step promises are <= options.tolerance, and the multipliers make the
// Lagrangian stationary to 1e-6, as a rule to 1e-12; acceptable: only the latter fails, as where the rows
// have no multipliers at all. infeasible: only where shape().convex or where the linear rows contradict; the
// ray is that of the rows linearized at x, exact to about 1e-7. A violation that is least nearby, but not
// known to be least, ends as numerical_failure with "no feasible point found".
// Sources: Mehrotra (1992), Gondzio (1996), Vanderbei (1995), Ruiz (2001); see the files of this folder.
#pragma once

#include "solvers/structured/structured_options.hpp"

namespace camopt {

[[nodiscard]] std::unique_ptr<Solver> make_structured_solver();

}  // namespace camopt
