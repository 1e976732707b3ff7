// SPDX-License-Identifier: MIT
#include "input/loading/known_scene.hpp"

#include "dynamics/train_formulas.hpp"

namespace camopt {

Scene known_scene(std::string_view toml, std::string_view name, const input::KnownNames& known,
                  std::span<const std::string> settings) {
    Scene scene = input::read_scene(toml, name, known, settings);
    try {
        complete_dynamics(scene);
    } catch (const SceneError& error) {
        // Faults found by the formulas of the train are reported with their location in the file.
        input::fail_in_scene({toml, name, settings}, error.fault().member, words_of(error.fault()));
    }
    return scene;
}

}  // namespace camopt
