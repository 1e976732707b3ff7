// SPDX-License-Identifier: MIT
// The solve itself, without the relaxation that explains an infeasible scene (which solves scenes of its
// own).
#pragma once

#include "studies/delivered/solution.hpp"
#include "studies/search/grid_memory.hpp"

namespace camopt {

/// `memory`: of the scene solved before, and then of this one; null: none.
[[nodiscard]] Solution solve_without_explaining(const Scene& given, const SolveControl& control,
                                                GridMemory* memory = nullptr);

}  // namespace camopt
