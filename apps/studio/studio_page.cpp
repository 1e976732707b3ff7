// SPDX-License-Identifier: MIT
#include "apps/studio/studio_page.hpp"

#include "apps/studio/request_room.hpp"
#include "core/errors.hpp"
#include "input/loading/load_scene.hpp"
#include "input/scene_document.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "output/csv/motion_csv.hpp"
#include "output/json/result_json.hpp"
#include "output/page/page_html.hpp"
#include "output/report/cam_files.hpp"
#include "studies/checked/checked_cam.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace camopt::apps {

namespace {

using Json = nlohmann::ordered_json;

/// Every law by key and title.
Json catalogue_json() {
    Json laws = Json::array();
    for (const LawInfo& law : law_catalogue()) laws.push_back({{"key", law.key}, {"title", law.title}});
    return laws;
}

struct Download {
    std::string_view name, file, type;
    bool needs_motion = true;
    std::string (*text)(const Solution& solution, const RunOrigin& origin);
};

std::string motion_table(const Solution& solution, const RunOrigin&) {
    return motion_csv(solution);
}

std::string cam_table(const Solution& solution, const RunOrigin&) {
    return cam_view(solution, CamView::table);
}

std::string cam_drawing(const Solution& solution, const RunOrigin&) {
    return cam_view(solution, CamView::drawing);
}

std::string report_page(const Solution& solution, const RunOrigin& origin) {
    return report_html(solution, origin);
}

constexpr std::array downloads = {Download{"motion", "motion.csv", "text/csv", true, motion_table},
                                  Download{"cam", "cam.csv", "text/csv", true, cam_table},
                                  Download{"dxf", "cam.dxf", "image/vnd.dxf", true, cam_drawing},
                                  Download{"result", "result.json", "application/json", false, result_json},
                                  Download{"report", "report.html", "text/html", false, report_page}};

constexpr std::string_view scene_name = "scene";

const Download& download_named(std::string_view what) {
    const auto* const found = std::ranges::find(downloads, what, &Download::name);
    if (found == downloads.end())
        throw InputError(fmt::format("a download of this name is not known; allowed: {}",
                                     fmt::join(download_names(), ", ")));
    return *found;
}

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
    data["downloads"] = download_names();
    page["studio"] = std::move(data);
    PageHtml html;
    html.title = "camopt studio";
    html.data = page.dump(-1, ' ', false, Json::error_handler_t::replace);
    html.solids = true;  // the next scene may be three-dimensional
    for (const char* const name : {"controls.js", "panel.js", "studio.js"})
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

std::vector<std::string_view> download_names() {
    std::vector<std::string_view> names = {scene_name};
    for (const Download& download : downloads) names.push_back(download.name);
    return names;
}

StudioAnswer studio_download(std::string_view what, const StudioScene& given, const SolveControl& control) {
    if (what == scene_name)
        return {.type = "application/toml", .body = given.text, .file_name = "scene.toml"};
    const Download& download = download_named(what);
    Solution solution = solve(given.scene, control);
    if (download.needs_motion && !solution.motion)
        throw InputError(fmt::format("{}: there is no motion to write: the scene is {}", download.file,
                                     name_of(solution.certificate.verdict)));
    if (solution.motion) add_forward_check(solution);
    const RunOrigin origin{"scene.toml", "camopt solve scene.toml", given.text};
    return {.type = std::string(download.type),
            .body = download.text(solution, origin),
            .file_name = std::string(download.file)};
}

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
