// SPDX-License-Identifier: MIT
#include "input/loading/load_scene.hpp"

#include "profiles/factory/cam_formulas.hpp"

namespace camopt {

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
    return known_scene(toml, name, known, settings);
}

}  // namespace camopt
