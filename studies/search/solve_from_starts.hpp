// SPDX-License-Identifier: MIT
// Problems that are not convex: a convex relaxation first, then a search from several starts.
//
// The relaxation leaves out every rule that is not known to be convex. Where its optimum keeps those rules
// too, it is the optimum of the whole, proved. Where it has no motion at all, neither has the whole.
// Otherwise its bound stands beside the best of the seeded starts: its own optimum, the smoothest motion,
// random ones.
#pragma once

#include "objectives/grid/cam_problem.hpp"
#include "scene/scene.hpp"
#include "solvers/exchange/exchange.hpp"
#include "studies/search/grid_memory.hpp"

#include <functional>

namespace camopt {

struct StartsResult {
    ContinuousResult result;
    int starts = 0;  ///< searches that ran; 0 where the relaxation settled everything
};

/// Where neither settles it the best motion is bounded over boxes (studies/bound/box_bound.hpp).
/// in_coefficients: the model written in few variables, for that bound.
/// memory: of the relaxations of a neighbouring scene, and then of this one's; null: none. One that only
/// looks goes on from the neighbour's motion, where it was found by a search: no relaxation, no bound.
[[nodiscard]] StartsResult solve_from_starts(const CamModel& model, const Solver& solver,
                                             const ExchangeOptions& exchange, const JudgeOptions& judge,
                                             int starts, unsigned seed, const SolveControl& control,
                                             const std::function<CamModel()>& in_coefficients,
                                             GridMemory* memory = nullptr);

/// Rules that are not convex for every motion: this is the way to solve the model.
[[nodiscard]] bool needs_starts(const CamModel& model);

}  // namespace camopt
