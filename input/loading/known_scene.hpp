// SPDX-License-Identifier: MIT
// Loads a scene with the names that a program knows: its laws, its solvers, the cams whose formulas it links.
#pragma once

#include "input/scene_reader.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "solvers/registry.hpp"

namespace camopt {

/// Without the formulas of cams, for a program that links those of one kind: set `cam_formulas`.
[[nodiscard]] inline input::KnownNames names_of_laws_and_solvers() {
    input::KnownNames known;
    for (const LawInfo& law : law_catalogue()) {
        known.laws.push_back(law.key);
        if (!law.rests) known.moving_laws.push_back(law.key);
        if (law.top == TopEnd::turning_point) known.turning_laws.push_back(law.key);
    }
    known.law_shape = [](const std::string& key) {
        return [law = std::shared_ptr<const Law>(make_law(key))](double t) {
            const auto share = law->at(t).derivative;
            return std::array<double, 2>{share[0], share[1]};
        };
    };
    for (const SolverEntry& solver : solver_entries()) known.solvers.push_back(solver.name);
    return known;
}

/// Reads a scene that can be solved: with the formulas of its train. Throws InputError "FILE:LINE:COLUMN:
/// key: found …; allowed: …"; `settings` as of load_scene (input/loading/load_scene.hpp).
[[nodiscard]] Scene known_scene(std::string_view toml, std::string_view name, const input::KnownNames& known,
                                std::span<const std::string> settings);

}  // namespace camopt
