// SPDX-License-Identifier: MIT
// A scene as text, with what the page's controls set since.
#include "apps/studio/studio_controls.hpp"
#include "apps/studio/studio_page.hpp"
#include "core/errors.hpp"
#include "core/text/list_text.hpp"
#include "input/loading/load_scene.hpp"
#include "input/scene_document.hpp"

#include <fmt/format.h>

#include <variant>

namespace camopt::apps {

namespace {

using SceneJson = nlohmann::ordered_json;

[[noreturn]] void unfit_setting(const std::string& key) {
    throw InputError(
        fmt::format("{}: found a value of another kind; allowed: a number, a text, true, false, a range of "
                    "min and max, or null",
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

/// The entry of a list as a TOML table; a text of JSON is one of TOML.
std::string entry_text(const std::string& key, const SceneJson& entry) {
    if (!entry.is_object()) unfit_setting(key);
    std::string text;
    for (const auto& [name, value] : entry.items()) {
        const bool range = value.is_object();
        append_item(text, fmt::format("{} = {}", SceneJson(name).dump(),
                                      range ? std::get<input::TomlValue>(range_value(key, value)).text
                                            : value.dump()));
    }
    return "{ " + text + " }";
}

}  // namespace

StudioScene studio_scene(const std::string& text, const SceneJson& settings, const std::string& name,
                         std::optional<LengthUnit> unit) {
    input::SceneDocument document(text, name, known_names());
    for (const auto& [key, value] : settings.items()) {
        if (value.is_null())
            document.unset(key);
        else if (value.is_object() && value.contains("insert"))
            document = {scene_with_entry(document.text(), key, entry_text(key, value["insert"])), name,
                        known_names()};
        else
            document.set(key, scene_value(key, value));
    }
    (void)document.scene();  // what is wrong is told with the places of the text as given
    std::string whole = document.text();
    if (unit) whole = scene_in_units(whole, *unit);
    Scene scene = scene_of_toml(whole, {}, name);
    if (unit) scene.length_unit = *unit;
    return {std::move(scene), std::move(whole)};
}

}  // namespace camopt::apps
