// SPDX-License-Identifier: MIT
// What the steps of a planned solve (planned_solve.hpp) are given.
#pragma once

#include "studies/search/known_solutions.hpp"
#include "studies/search/plan.hpp"
#include "studies/search/posed_scene.hpp"

namespace camopt {

/// Part of the time for a backend that another one follows.
inline constexpr double share_of_first = 0.5;

/// What takes part in a solve for given angles and breakpoints.
struct PlannedRun {
    PosedScene& posed;  ///< its model is moved from
    const SolvePlan& plan;
    const SolveControl& control;
    KnownSolutions& known;
    /// Not null: a relaxation that settles the whole but leaves its strokes ends the solve and sets this. The
    /// caller then holds the strokes; what is returned has no motion but the bound of the relaxation.
    bool* leaves_strokes = nullptr;
};

/// Solves one scene whose angles and breakpoints are given, by its own plan. The searches over these numbers
/// are given it: what solves a scene (planned_solve.hpp) begins them.
using SolveScene = std::function<Solution(const Scene& scene, const SolveControl& control)>;

}  // namespace camopt
