// SPDX-License-Identifier: MIT
#include "input/loading/load_scene.hpp"

#include "dynamics/train_formulas.hpp"
#include "profiles/factory/mechanism_factory.hpp"

namespace camopt {

Scene load_scene(const std::filesystem::path& file, std::span<const std::string> settings) {
    Scene scene = input::read_scene_file(file, known_names(), settings);
    complete_mechanism(scene);
    complete_dynamics(scene);
    return scene;
}

Scene scene_of_toml(std::string_view toml, std::span<const std::string> settings, std::string_view name,
                    const std::optional<std::filesystem::path>& folder) {
    input::KnownNames known = known_names();
    known.folder = folder;
    Scene scene = input::read_scene(toml, name, known, settings);
    complete_mechanism(scene);
    complete_dynamics(scene);
    return scene;
}

}  // namespace camopt
