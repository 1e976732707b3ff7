// SPDX-License-Identifier: MIT
#include "apps/studio/studio_downloads.hpp"

#include "core/errors.hpp"
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

namespace camopt::apps {

namespace {

struct Download {
    std::string_view name, file, type;
    bool needs_motion = true;
    std::string (*text)(const Solution& solution, const RunOrigin& origin);
};

std::string motion_table(const Solution& solution, const RunOrigin&) {
    return motion_csv(*solution.motion, solution.motion_peaks, solution.scene.motion);
}

std::string cam_table(const Solution& solution, const RunOrigin&) {
    return cam_view(solution, CamView::table);
}

std::string cam_drawing(const Solution& solution, const RunOrigin&) {
    return cam_view(solution, CamView::drawing);
}

constexpr std::array downloads = {Download{"motion", "motion.csv", "text/csv", true, motion_table},
                                  Download{"cam", "cam.csv", "text/csv", true, cam_table},
                                  Download{"dxf", "cam.dxf", "image/vnd.dxf", true, cam_drawing},
                                  Download{"result", "result.json", "application/json", false, result_json},
                                  Download{"report", "report.html", "text/html", false, report_html}};

constexpr std::string_view scene_name = "scene";

const Download& download_named(std::string_view what) {
    const auto* const found = std::ranges::find(downloads, what, &Download::name);
    if (found == downloads.end())
        throw InputError(fmt::format("a download of this name is not known; allowed: {}",
                                     fmt::join(download_names(), ", ")));
    return *found;
}

}  // namespace

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

}  // namespace camopt::apps
