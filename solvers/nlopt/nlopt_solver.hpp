// SPDX-License-Identifier: MIT
// Two algorithms of NLopt for small dense problems, n up to about 150:
//   nlopt.slsqp   sequential quadratic programming with gradients (D. Kraft, DFVLR-FB 88-28, 1988);
//   nlopt.cobyla  linear approximations without derivatives (M. J. D. Powell, 1994).
// Neither gives multipliers, and neither can be believed when it says "success": both say so on infeasible
// problems. The certificate judges.
//
// Equality rows stay equalities, a two-sided row becomes two inequalities, an infinite side is dropped, the
// start is clipped into the bounds. A value that is not finite never reaches NLopt: the solve is stopped
// instead (evaluation_error), because SLSQP and COBYLA go on for ever on a NaN.
#pragma once

#include "solvers/registry.hpp"
#include "solvers/solver.hpp"

#include <memory>
#include <string>

namespace camopt {

[[nodiscard]] SolverEntry nlopt_slsqp_entry();
[[nodiscard]] SolverEntry nlopt_cobyla_entry();

/// Throw UnavailableError where this build has no NLopt.
[[nodiscard]] std::unique_ptr<Solver> make_nlopt_slsqp_solver();
[[nodiscard]] std::unique_ptr<Solver> make_nlopt_cobyla_solver();

/// "2.7.1"; empty where this build has no NLopt.
[[nodiscard]] std::string nlopt_library_version();

}  // namespace camopt
