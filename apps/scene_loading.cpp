// SPDX-License-Identifier: MIT
#include "apps/scene_loading.hpp"

#include "input/scene_reader.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "output/report/text_file.hpp"
#include "profiles/factory/mechanism_factory.hpp"
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

std::vector<std::string> with_solver(std::vector<std::string> settings, const std::string& solver) {
    if (!solver.empty()) settings.push_back("solver.name=\"" + solver + "\"");
    return settings;
}

Scene load_scene(const std::string& file, const std::vector<std::string>& settings) {
    Scene scene = input::read_scene_file(file, known_names(), settings);
    complete_mechanism(scene);
    return scene;
}

LoadedScene load_scene_and_text(const std::string& file, const std::vector<std::string>& settings) {
    const SceneText given{file, input::scene_file_text(file)};
    return {load_scene(given, settings), input::scene_with_overrides(given.text, file, settings)};
}

SceneText read_scene_text(const std::string& file) {
    return {file, read_text_file(file)};
}

Scene load_scene(const SceneText& scene, std::span<const std::string> settings) {
    Scene read = input::read_scene(scene.text, scene.name, known_names(), settings);
    complete_mechanism(read);
    return read;
}

}  // namespace camopt::apps
