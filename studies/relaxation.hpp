// SPDX-License-Identifier: MIT
// For an infeasible scene: the least change of each limit alone, the others kept, that would make it
// feasible.
//
// Found by solving: the limited peak is minimized under the other limits; its optimum is the least limit that
// works.
#pragma once

#include "studies/solution.hpp"

#include <vector>

namespace camopt {

[[nodiscard]] std::vector<Relaxation> relaxations(const Scene& scene, const SolveControl& control);

}  // namespace camopt
