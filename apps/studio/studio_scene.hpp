// SPDX-License-Identifier: MIT
// The scene a page asks about: the text of a scene file and what its controls set since.
#pragma once

#include "scene/scene.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace camopt::apps {

struct StudioScene {
    Scene scene;       ///< ready to be solved
    std::string text;  ///< the same as one scene file
};

/// `settings`: an object, KEY: value. A number, true, false or a text is set as `--set KEY=VALUE` does; an
/// object { "min": …, "max": … } is a range; null takes the key out. Throws InputError for whatever the
/// reader of scene files refuses, in its words, and for values of other kinds; `name` stands in the place of
/// the file. The text is all there is: nothing in it makes camopt open a file.
[[nodiscard]] StudioScene studio_scene(const std::string& text, const nlohmann::ordered_json& settings,
                                       const std::string& name);

}  // namespace camopt::apps
