// SPDX-License-Identifier: MIT
#include "apps/studio/studio_page.hpp"

#include "apps/studio/request_room.hpp"
#include "apps/studio/studio_controls.hpp"
#include "core/errors.hpp"
#include "input/loading/load_scene.hpp"
#include "input/scene_document.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "output/page/page_html.hpp"

#include <fmt/format.h>

#include <variant>

namespace camopt::apps {

namespace {

using Json = nlohmann::ordered_json;

/// Every law by key and title.
Json catalogue_json() {
    Json laws = Json::array();
    for (const LawInfo& law : law_catalogue()) laws.push_back({{"key", law.key}, {"title", law.title}});
    return laws;
}

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
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", SceneJson(name).dump(),
                            range ? std::get<input::TomlValue>(range_value(key, value)).text : value.dump());
    }
    return "{ " + text + " }";
}

}  // namespace

StudioStart first_scene() {
    return {"new scene", R"(title = "A rise between two dwells"

[motion]
type = "DRD"
lift_mm = 10
rise_deg = 120
speed_rpm = 300

[spline]
degree = 3
segments = 32

[objective]
velocity = 0.4
acceleration = 0.4
jerk = 0.2
)"};
}

StudioAnswer studio_page(const StudioStart& start, const std::string& answer) {
    Json data = Json::parse(answer);
    // The page's own data, and beside it what the studio's scripts begin with.
    Json page = std::move(data["data"]);
    data.erase("data");
    data["name"] = start.name;
    data["catalogue"] = catalogue_json();
    data["files"] = Json::array();
    for (const DownloadName& file : download_names())
        data["files"].push_back({{"name", file.name}, {"words", file.words}});
    page["studio"] = std::move(data);
    PageHtml html;
    html.title = "camopt studio";
    html.data = page.dump(-1, ' ', false, Json::error_handler_t::replace);
    html.solids = true;  // the next scene may be three-dimensional
    for (const char* const name : {"controls.js", "handles.js", "panel.js", "studio.js"})
        html.scripts.emplace_back(studio_asset(name));
    html.styles.emplace_back(studio_asset("studio.css"));
    html.connect = "'self'";
    html.nonce = random_token();
    return {
        .type = "text/html; charset=utf-8",
        .body = page_html(html),
        .content_policy = fmt::format("default-src 'none'; script-src 'nonce-{}'; style-src 'unsafe-inline'; "
                                      "img-src data: blob:; connect-src 'self'; base-uri 'none'; "
                                      "form-action 'none'; frame-ancestors 'none'",
                                      html.nonce)};
}

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
