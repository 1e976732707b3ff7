// SPDX-License-Identifier: MIT
// Loads a scene from a file or a text with all names that camopt knows: laws, solvers, kinds of cams,
// including those added by the program. The result can be solved.
#pragma once

#include "input/scene_reader.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "solvers/registry.hpp"

namespace camopt {

// All laws, solvers and kinds of cams, including those added by the program: the names for input::read_scene.

/// All of them.
[[nodiscard]] input::KnownNames known_names();

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

// Loads a scene from a file or a text with all names that camopt knows: laws, solvers, kinds of cams,
// including those added by the program. The result can be solved.

/// `settings`: "KEY=VALUE" as for `--set`, applied to the file. Throws InputError "FILE:LINE:COLUMN: key:
/// found …; allowed: …".
[[nodiscard]] Scene load_scene(const std::filesystem::path& file, std::span<const std::string> settings = {});

/// The same for a text; `name` replaces FILE. It may name a table (measured.table) only if a `folder` is
/// given.
[[nodiscard]] Scene scene_of_toml(std::string_view toml, std::span<const std::string> settings = {},
                                  std::string_view name = "scene",
                                  const std::optional<std::filesystem::path>& folder = {});

}  // namespace camopt
