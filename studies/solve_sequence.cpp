// SPDX-License-Identifier: MIT
#include "studies/solve_sequence.hpp"

#include "studies/solve_without_explaining.hpp"

namespace camopt {

Solution SolveSequence::solve(const Scene& scene, const SolveControl& control) {
    return solve_without_explaining(scene, control, &memory_);
}

}  // namespace camopt
