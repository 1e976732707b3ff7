// SPDX-License-Identifier: MIT
// All laws, solvers and kinds of cams, including those added by the program: the names for input::read_scene.
#pragma once

#include "input/scene_reader.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "solvers/registry.hpp"

namespace camopt {

/// All of them.
[[nodiscard]] input::KnownNames known_names();

/// Without the formulas of cams, for a program that links those of one kind: set `cam_formulas`.
[[nodiscard]] inline input::KnownNames names_of_laws_and_solvers() {
    input::KnownNames known;
    for (const LawInfo& law : law_catalogue()) {
        known.laws.push_back(law.key);
        if (!law.rests) known.moving_laws.push_back(law.key);
    }
    for (const SolverEntry& solver : solver_entries()) known.solvers.push_back(solver.name);
    return known;
}

}  // namespace camopt
