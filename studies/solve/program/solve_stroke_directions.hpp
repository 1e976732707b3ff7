// SPDX-License-Identifier: MIT
// Programs with free displacements (objectives/free_displacements.hpp): does each free stroke rise or fall?
//
// motion.within_lift and motion.monotone hold a stroke by its direction, which a free displacement leaves
// open. Without these rules the scene is solved first: mostly its motion satisfies them for the directions
// that it takes, and is the optimum. Else the stroke that leaves its range most is split into two cases, it
// rises or it falls, each an ordinary solve with the rules of that direction; together they hold everything.
#pragma once

#include "objectives/strokes.hpp"
#include "studies/delivered/solution.hpp"

#include <functional>
#include <span>

namespace camopt {

/// The ordinary solve of a scene whose free strokes have these directions, those missing being open.
using SolveDirected = std::function<Solution(std::span<const StrokeDirection>)>;

/// Optimal within solver.gap of the least bound of all cases, infeasible where every case is.
[[nodiscard]] Solution solve_stroke_directions(const Scene& scene, const SolveDirected& solve,
                                               const SolveControl& control);

}  // namespace camopt
