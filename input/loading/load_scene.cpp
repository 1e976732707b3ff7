// SPDX-License-Identifier: MIT
#include "input/loading/load_scene.hpp"

#include "dynamics/train_formulas.hpp"
#include "profiles/factory/cam_formulas.hpp"

namespace camopt {

namespace {

/// Faults found by the formulas of the train are reported with their location in the file.
void complete(Scene& scene, const input::SceneOrigin& origin) {
    try {
        complete_dynamics(scene);
    } catch (const SceneError& error) {
        input::fail_in_scene(origin, error.fault().member, words_of(error.fault()));
    }
}

}  // namespace

input::KnownNames known_names() {
    input::KnownNames known = names_of_laws_and_solvers();
    known.cam_formulas = cam_formulas;
    return known;
}

Scene load_scene(const std::filesystem::path& file, std::span<const std::string> settings) {
    return scene_of_toml(input::scene_file_text(file), settings, file.string(), file.parent_path());
}

Scene scene_of_toml(std::string_view toml, std::span<const std::string> settings, std::string_view name,
                    const std::optional<std::filesystem::path>& folder) {
    input::KnownNames known = known_names();
    known.folder = folder;
    Scene scene = input::read_scene(toml, name, known, settings);
    complete(scene, {toml, name, settings});
    return scene;
}

}  // namespace camopt
