// SPDX-License-Identifier: MIT
#include "input/loading/load_scene.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "profiles/factory/mechanism_factory.hpp"
#include "solvers/registry.hpp"

namespace camopt {

input::KnownNames known_names() {
    input::KnownNames known;
    for (const LawInfo& law : law_catalogue()) known.laws.push_back(law.key);
    for (const SolverEntry& solver : solver_entries()) known.solvers.push_back(solver.name);
    return known;
}

Scene load_scene(const std::filesystem::path& file, std::span<const std::string> settings) {
    Scene scene = input::read_scene_file(file, known_names(), settings);
    complete_mechanism(scene);
    return scene;
}

Scene scene_of_toml(std::string_view toml, std::span<const std::string> settings, std::string_view name) {
    Scene scene = input::read_scene(toml, name, known_names(), settings);
    complete_mechanism(scene);
    return scene;
}

}  // namespace camopt
