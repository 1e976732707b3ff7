// SPDX-License-Identifier: MIT
#include "apps/scene_loading.hpp"

#include "apps/program_parts.hpp"
#include "core/text/text_file.hpp"
#include "input/loading/known_scene.hpp"

namespace camopt::apps {

namespace {

/// Where the tables of a scene file lie.
std::filesystem::path folder_of(const std::string& file) {
    return std::filesystem::path(file).parent_path();
}

}  // namespace

std::vector<std::string> with_solver(std::vector<std::string> settings, const std::string& solver) {
    if (!solver.empty()) settings.push_back("solver.name=\"" + solver + "\"");
    return settings;
}

Scene load_scene(const std::string& file, const std::vector<std::string>& settings) {
    return load_scene(SceneText{file, input::scene_file_text(file)}, settings);
}

LoadedScene load_scene_and_text(const std::string& file, const std::vector<std::string>& settings) {
    const SceneText given{file, input::scene_file_text(file)};
    return {load_scene(given, settings),
            input::scene_with_overrides(given.text, file, settings, folder_of(file))};
}

std::string placed_words(const SceneError& error, const std::string& file,
                         std::span<const std::string> settings) {
    if (!std::filesystem::is_regular_file(file)) return error.what();
    try {
        const std::string text = input::scene_file_text(file);
        input::fail_in_scene({text, file, settings}, error.fault().member, words_of(error.fault()));
    } catch (const InputError& placed) {
        return placed.what();
    }
}

LengthUnit length_unit_of(std::string_view units, LengthUnit otherwise) {
    for (const LengthUnit unit : {LengthUnit::millimetre, LengthUnit::inch})
        if (units == name_of(unit)) return unit;
    return otherwise;
}

void show_in(Scene& scene, std::string_view units) {
    scene.length_unit = length_unit_of(units, scene.length_unit);
}

SceneText read_scene_text(const std::string& file) {
    return {file, read_text_file(file)};
}

Scene load_scene(const SceneText& scene, std::span<const std::string> settings) {
    input::KnownNames known = names_of_laws_and_solvers();
    known.cam_formulas = program_parts().cam_formulas;
    known.folder = folder_of(scene.name);
    return known_scene(scene.text, scene.name, known, settings);
}

}  // namespace camopt::apps
