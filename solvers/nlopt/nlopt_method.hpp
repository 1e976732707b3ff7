// SPDX-License-Identifier: MIT
// The algorithms of NLopt that camopt takes; what each is: solvers/nlopt/nlopt_solver.hpp.
#pragma once

namespace camopt {

enum class NloptMethod { slsqp, cobyla, mma, ccsaq, isres, auglag_lbfgs, auglag_sbplx, auglag_neldermead };

}  // namespace camopt
