// SPDX-License-Identifier: MIT
// The grid problem on which an exchange ended: a linear program whose optimum is that of the whole scene.
// What other solvers of linear programs are compared on.
#pragma once

#include "objectives/grid/cam_problem.hpp"
#include "scene/scene.hpp"

namespace camopt::benchmarks {

/// Weights 0.4, 0.4, 0.2 over 1.76, 5.53, 69, DRD, no tie-break.
[[nodiscard]] Scene drd_scene(int degree, int segments);

struct FinalGrid {
    CamProblem problem;
    int rounds = 0;
    double objective = 0.0;  ///< true, of the curve found
};

/// Exchanged by the structured solver over states at `tolerance`. Throws ModelError where that does not end.
[[nodiscard]] FinalGrid final_grid(const Scene& scene, double tolerance);

/// The same rows at the same cam angles over another design vector of the same splines.
[[nodiscard]] CamProblem rewritten(const FinalGrid& grid, const Scene& scene, DesignKind design);

}  // namespace camopt::benchmarks
