// SPDX-License-Identifier: MIT
// A scene from the text of a scene file, so that a notebook can show it as people write it.
#pragma once

#include <camopt/laws.hpp>
#include <camopt/mechanism_factory.hpp>
#include <camopt/scene_file.hpp>
#include <camopt/solver_registry.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace notebook {

/// settings: "KEY=VALUE", as the option --set of the program takes them. Throws InputError, which names line
/// and column of the text.
inline camopt::Scene scene_of(std::string_view toml, const std::vector<std::string>& settings = {}) {
    camopt::input::KnownNames known;
    for (const auto& law : camopt::law_catalogue()) known.laws.push_back(law.key);
    for (const auto& solver : camopt::solver_entries()) known.solvers.push_back(solver.name);
    camopt::Scene scene = camopt::input::read_scene(toml, "scene", known, settings);
    camopt::complete_mechanism(scene);
    return scene;
}

}  // namespace notebook
