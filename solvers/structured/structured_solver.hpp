// SPDX-License-Identifier: MIT
// camopt's own interior point for convex problems with linear constraints; needs nothing but Eigen.
#pragma once

#include <memory>

#include "solvers/solver.hpp"

namespace camopt {

[[nodiscard]] std::unique_ptr<Solver> make_structured_solver();

}  // namespace camopt
