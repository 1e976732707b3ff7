// SPDX-License-Identifier: MIT
// Neighbouring scenes one after another, each solved from what the last one found.
//
// The verdict and the objective are those of a cold solve (to the solver's tolerance); only the way there is
// shorter. Scenes that are no neighbours (another spline, another motion) are solved cold.
#pragma once

#include "scene/scene.hpp"
#include "solvers/solver.hpp"
#include "studies/delivered/solution.hpp"
#include "studies/search/grid_memory.hpp"

#include <utility>

namespace camopt {

class SolveSequence {
 public:
    SolveSequence() = default;
    explicit SolveSequence(GridMemory memory) : memory_(std::move(memory)) {}

    /// As solve() (studies/solve/solve.hpp), but infeasible scenes are not explained: no relaxation is
    /// sought.
    [[nodiscard]] Solution solve(const Scene& scene, const SolveControl& control);

    /// A picture before its proof: problems that are not convex are searched once, from the last motion, and
    /// have no bound then.
    [[nodiscard]] Solution look(const Scene& scene, const SolveControl& control);

 private:
    GridMemory memory_;
};

}  // namespace camopt
