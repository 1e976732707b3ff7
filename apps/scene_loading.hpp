// SPDX-License-Identifier: MIT
// A scene file together with everything this camopt knows by name.
#pragma once

#include "scene/scene.hpp"

namespace camopt {
struct Solution;
}

namespace camopt::apps {

/// The settings, and --solver as one of them.
[[nodiscard]] std::vector<std::string> with_solver(std::vector<std::string> settings,
                                                   const std::string& solver);

/// Throws InputError for anything wrong with the file or the settings (KEY=VALUE).
[[nodiscard]] Scene load_scene(const std::string& file, const std::vector<std::string>& settings);

/// The same with the text of the scene as read: settings are worked into it (input::scene_with_overrides).
struct LoadedScene {
    Scene scene;
    std::string text;
};
[[nodiscard]] LoadedScene load_scene_and_text(const std::string& file,
                                              const std::vector<std::string>& settings);

/// What was found wrong with a scene after it was read, with file and line; as it stands where `file` is no
/// scene file.
[[nodiscard]] std::string placed_words(const SceneError& error, const std::string& file,
                                       std::span<const std::string> settings);

/// In which lengths people read it: "mm" or "in"; empty: as the scene is written.
void show_in(Scene& scene, std::string_view units);
/// The same of anything else; `otherwise` where it is empty.
[[nodiscard]] LengthUnit length_unit_of(std::string_view units, LengthUnit otherwise);

/// A scene file that is read once and made into scenes many times.
struct SceneText {
    std::string name;  ///< of the file, for messages
    std::string text;
};
[[nodiscard]] SceneText read_scene_text(const std::string& file);
[[nodiscard]] Scene load_scene(const SceneText& scene, std::span<const std::string> settings);

/// The solution of a scene file, which is solved, or of a result folder, which is used as it is and takes no
/// settings. check: throws for a scene that the command refuses, before the solve.
[[nodiscard]] Solution solved_or_read(const std::string& what, const std::vector<std::string>& settings,
                                      const std::function<void(const Scene&)>& check);

}  // namespace camopt::apps
