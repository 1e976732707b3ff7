// SPDX-License-Identifier: MIT
// Programs with free displacements (objectives/free_displacements.hpp): which displacements are best?
//
// For given displacements the scene is an ordinary one. Cases (a sign and an interval for each free
// displacement, free_displacement_cases.hpp) are bounded by relaxations and split, the one of the least bound
// first; the displacements that a relaxation likes are tried in the ordinary solve. Within `solver.gap` of
// the least bound the verdict is optimal. Otherwise the displacements are moved by themselves until no step
// helps.
#pragma once

#include "objectives/free_displacements.hpp"
#include "studies/solve/program/program_search.hpp"

namespace camopt {

/// scene: a program with free displacements whose conditions do not contradict. solve_given: of scenes
/// without.
[[nodiscard]] Solution solve_free_displacements(const Scene& scene, const Peaks& reference,
                                                const SolveGiven& solve_given, const SolveControl& control);

}  // namespace camopt
