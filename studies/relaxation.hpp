// SPDX-License-Identifier: MIT
// For an infeasible scene: the least change of each limit and dimension alone, the others kept, that would
// make it feasible.
//
// Found by solving. A cap on a peak: the peak is minimized under the other limits. Everything else: the least
// common violation t(v) of the scene with the value v is brought to zero, first by steps that double, then by
// regula falsi; v is taken from the feasible side. All of it together gets solver.max_seconds; a change whose
// search does not end in time is left out.
#pragma once

#include "studies/solution.hpp"

#include <vector>

namespace camopt {

[[nodiscard]] std::vector<Relaxation> relaxations(const Scene& scene, const SolveControl& control);

}  // namespace camopt
