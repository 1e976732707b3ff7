// SPDX-License-Identifier: MIT
#include "apps/scene_loading.hpp"

#include "input/scene_reader.hpp"
#include "motions/law_catalogue.hpp"
#include "output/text_file.hpp"
#include "solvers/registry.hpp"

namespace camopt::apps {

namespace {

input::KnownNames known_names() {
    input::KnownNames known;
    for (const LawInfo& law : law_catalogue()) known.laws.push_back(law.key);
    for (const SolverEntry& solver : solver_entries()) known.solvers.push_back(solver.name);
    return known;
}

}  // namespace

Scene load_scene(const std::string& file, const std::vector<std::string>& settings) {
    return input::read_scene_file(file, known_names(), settings);
}

SceneText read_scene_text(const std::string& file) {
    return {file, read_text_file(file)};
}

Scene load_scene(const SceneText& scene, std::span<const std::string> settings) {
    return input::read_scene(scene.text, scene.name, known_names(), settings);
}

}  // namespace camopt::apps
