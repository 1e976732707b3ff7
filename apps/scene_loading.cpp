// SPDX-License-Identifier: MIT
#include "apps/scene_loading.hpp"

#include "apps/terminal.hpp"
#include "core/text/text_file.hpp"
#include "input/loading/load_scene.hpp"
#include "output/report/result_folder.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

#include <system_error>

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
    return camopt::load_scene(std::filesystem::path(file), settings);
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
    return scene_of_toml(scene.text, settings, scene.name, folder_of(scene.name));
}

Solution solved_or_read(const std::string& what, const std::vector<std::string>& settings,
                        const std::function<void(const Scene&)>& check) {
    std::error_code ignored;
    const bool folder = std::filesystem::is_directory(what, ignored);
    if (folder && !settings.empty())
        throw InputError(
            fmt::format("{}: {}: found with a result folder, which is used unchanged; allowed: with a scene",
                        what, settings.front().starts_with("solver.name=\"") ? "--solver" : "--set"));
    if (folder) {
        Solution solution = read_result_folder(what, [](const std::string& text, const std::string& name) {
                                return load_scene(SceneText{name, text}, {});
                            }).solution;
        check(solution.scene);
        return solution;
    }
    const Scene scene = load_scene(what, settings);
    check(scene);
    Solution solution = solve(scene, {InterruptWatch::interrupted, terminal_progress()});
    end_progress();
    return solution;
}

}  // namespace camopt::apps
