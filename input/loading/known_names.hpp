// SPDX-License-Identifier: MIT
// Every law and solver there is, the program's own among them: what input::read_scene is told of names.
#pragma once

#include "input/scene_reader.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "solvers/registry.hpp"

namespace camopt {

[[nodiscard]] inline input::KnownNames known_names() {
    input::KnownNames known;
    for (const LawInfo& law : law_catalogue()) {
        known.laws.push_back(law.key);
        if (!law.rests) known.moving_laws.push_back(law.key);
    }
    for (const SolverEntry& solver : solver_entries()) known.solvers.push_back(solver.name);
    return known;
}

}  // namespace camopt
