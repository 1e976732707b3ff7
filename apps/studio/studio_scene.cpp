// SPDX-License-Identifier: MIT
#include "apps/studio/studio_scene.hpp"

#include "core/errors.hpp"
#include "input/document/scene_document.hpp"
#include "input/loading/load_scene.hpp"

#include <fmt/format.h>

namespace camopt::apps {

namespace {

using SceneJson = nlohmann::ordered_json;

[[noreturn]] void unfit_setting(const std::string& key) {
    throw InputError(
        fmt::format("{}: found a value of another kind; allowed: a number, a text, true, false, a range of "
                    "min and max, or "
                    "null",
                    key));
}

input::SceneValue range_value(const std::string& key, const SceneJson& value) {
    if (value.size() != 2 || !value.contains("min") || !value.contains("max") || !value["min"].is_number() ||
        !value["max"].is_number())
        unfit_setting(key);
    return input::TomlValue{
        fmt::format("{{ min = {}, max = {} }}", value["min"].get<double>(), value["max"].get<double>())};
}

input::SceneValue scene_value(const std::string& key, const SceneJson& value) {
    if (value.is_boolean()) return value.get<bool>();
    if (value.is_number()) return value.get<double>();
    if (value.is_string()) return value.get<std::string>();
    if (value.is_object()) return range_value(key, value);
    unfit_setting(key);
}

}  // namespace

StudioScene studio_scene(const std::string& text, const SceneJson& settings, const std::string& name) {
    input::SceneDocument document(text, name, known_names());
    for (const auto& [key, value] : settings.items()) {
        if (value.is_null())
            document.unset(key);
        else
            document.set(key, scene_value(key, value));
    }
    (void)document.scene();  // what is wrong is told with the places of the text as given
    std::string whole = document.text();
    Scene scene = scene_of_toml(whole, {}, name);
    return {std::move(scene), std::move(whole)};
}

}  // namespace camopt::apps
