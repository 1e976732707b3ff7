// SPDX-License-Identifier: MIT
// Algorithms of NLopt for small dense problems:
//   nlopt.slsqp             sequential quadratic programming with gradients (D. Kraft, DFVLR-FB 88-28, 1988);
//   nlopt.cobyla            linear approximations without derivatives (M. J. D. Powell, 1994);
//   nlopt.mma, nlopt.ccsaq  conservative convex separable approximations, with moving asymptotes or
//                           quadratic (K. Svanberg, SIAM J. Optim. 12 (2002) 555-573);
//   nlopt.isres             stochastic ranking evolution, global in a box (T. P. Runarsson, X. Yao, IEEE
//                           Trans. SMC-C 35 (2005) 233-243);
//   nlopt.auglag.…          augmented Lagrangian (E. G. Birgin, J. M. Martínez, Optim. Methods Softw. 23
//                           (2008) 177-195) around L-BFGS, Subplex (T. H. Rowan, thesis, Austin 1990) or
//                           Nelder-Mead.
// None gives multipliers, and all may report success on infeasible problems: the certificate decides.
//
// Equality rows stay equalities; MMA, CCSAQ and ISRES take none and answer "unsupported". A two-sided row
// becomes two inequalities, an infinite side is dropped, the start is clipped into the bounds. A value that
// is not finite never reaches NLopt: the solve is stopped instead (evaluation_error), because SLSQP and
// COBYLA do not terminate on a NaN.
#pragma once

#include "solvers/nlopt/nlopt_method.hpp"
#include "solvers/registry.hpp"

namespace camopt {

[[nodiscard]] SolverEntry nlopt_entry(NloptMethod method);

/// Throws UnavailableError where this build has no NLopt.
[[nodiscard]] std::unique_ptr<Solver> make_nlopt_solver(NloptMethod method);

/// The same without an argument, as the registry wants them.
template <NloptMethod method>
[[nodiscard]] SolverEntry nlopt_entry() {
    return nlopt_entry(method);
}
template <NloptMethod method>
[[nodiscard]] std::unique_ptr<Solver> make_nlopt_solver() {
    return make_nlopt_solver(method);
}

/// "2.7.1"; empty where this build has no NLopt.
[[nodiscard]] std::string nlopt_library_version();

}  // namespace camopt
