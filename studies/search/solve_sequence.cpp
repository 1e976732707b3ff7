// SPDX-License-Identifier: MIT
#include "studies/search/solve_sequence.hpp"

#include "studies/search/solve_without_explaining.hpp"

namespace camopt {

Solution SolveSequence::solve(const Scene& scene, const SolveControl& control) {
    memory_.only_looks = false;
    return solve_without_explaining(scene, control, &memory_);
}

Solution SolveSequence::look(const Scene& scene, const SolveControl& control) {
    memory_.only_looks = true;
    return solve_without_explaining(scene, control, &memory_);
}

}  // namespace camopt
