// SPDX-License-Identifier: MIT
// The solve itself, without the relaxation that explains an infeasible scene (which solves scenes of its
// own).
#pragma once

#include "studies/solution.hpp"

namespace camopt {

[[nodiscard]] Solution solve_without_explaining(const Scene& scene, const SolveControl& control);

}  // namespace camopt
