// SPDX-License-Identifier: MIT
// The files of a scene that the studio's page may ask for: one row each.
#include "apps/studio/studio_page.hpp"
#include "core/errors.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "report/cam/cam_files.hpp"
#include "report/exports/exports.hpp"
#include "report/exports/workshop.hpp"
#include "report/json/result_json.hpp"
#include "studies/checked/checked_cam.hpp"
#include "studies/solve/solve.hpp"
#include "studies/spatial/spatial_forward_check.hpp"

#include <fmt/ranges.h>

#include <cctype>

namespace camopt::apps {

namespace {

using FileText = std::function<std::string(const Solution&, const RunOrigin&)>;

struct StudioFile {
    std::string name, words, file, type;
    FileText text;
    std::optional<CamOutput> output = {};  ///< of a cam that gives it; none: of every scene
    bool needs_motion = true;
};

/// As `camopt export` and `camopt solve --out` write it.
FileText exported_text(const std::string& name) {
    return [name](const Solution& solution, const RunOrigin& origin) {
        return exported_file(solution, name, {.origin = origin});
    };
}

/// Drawing, solid and program of one disk.
void add_piece(std::vector<StudioFile>& files, std::size_t piece) {
    const std::string key = piece == 0 ? "" : "second_", end = piece == 0 ? "" : ", second disk";
    const std::string file = piece == 0 ? "" : "_second";
    const CamOutput drawn = piece == 0 ? CamOutput::sheet : CamOutput::second_sheet;
    const CamOutput made = piece == 0 ? CamOutput::solid : CamOutput::second_sheet;
    const auto sheet = [&](const std::string& format, const char* type) {
        std::string upper = format;
        std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return std::toupper(c); });
        const std::string name = fmt::format("drawing{}.{}", file, format);
        files.push_back({key + "drawing_" + format, fmt::format("Workshop drawing ({}){}", upper, end), name,
                         type, exported_text(name), drawn});
    };
    if (workshop()->has_pdf()) sheet("pdf", "application/pdf");
    sheet("svg", "image/svg+xml");
    sheet("dxf", "image/vnd.dxf");
    const std::string solid = fmt::format("cam{}.step", file), program = fmt::format("cam{}.nc", file);
    if (workshop()->has_step())
        files.push_back({key + "step", "Solid or flanks (STEP)" + end, solid, "model/step",
                         [solid](const Solution& solution, const RunOrigin& origin) {
                             return exported_file(solution, step_name(solution, solid), {.origin = origin});
                         },
                         made});
    files.push_back({key + "nc", "NC program" + end, program, "text/plain", exported_text(program),
                     piece == 0 ? CamOutput::program : CamOutput::second_sheet});
}

std::vector<StudioFile> make_files() {
    std::vector<StudioFile> files = {
        {"motion", "Motion (CSV)", "motion.csv", "text/csv", exported_text("motion.csv")},
        {"cam", "Cam (CSV)", "cam.csv", "text/csv",
         [](const Solution& solution, const RunOrigin&) { return cam_view(solution, CamView::table); },
         CamOutput::outline}};
    if (workshop() != nullptr) {
        files.push_back({"dxf", "Cam (DXF)", "cam.dxf", "image/vnd.dxf", exported_text(drawn_profile),
                         CamOutput::outline});
        for (const std::size_t piece : {std::size_t{0}, std::size_t{1}}) add_piece(files, piece);
    }
    files.push_back({"result",
                     "Result (JSON)",
                     "result.json",
                     "application/json",
                     exported_text("result.json"),
                     {},
                     false});
    files.push_back({"certificate",
                     "Certificate (JSON)",
                     "certificate.json",
                     "application/json",
                     exported_text("certificate.json"),
                     {},
                     false});
    files.push_back(
        {"report", "Report (HTML)", "report.html", "text/html", exported_text("report.html"), {}, false});
    if (workshop() != nullptr)
        for (const Controller& controller : workshop()->controllers())
            files.push_back({"plc_" + controller.key, "Controller: " + controller.name, controller.file,
                             "text/plain", exported_text(controller.file)});
    return files;
}

const std::vector<StudioFile>& studio_files() {
    static const std::vector<StudioFile> files = make_files();
    return files;
}

bool has_file(const Scene& scene, std::optional<CamOutput> output) {
    if (!output) return true;
    if (!scene.cam || !cam_kind(scene.cam->type)->gives(*output)) return false;  // it was read: it has a kind
    if (*output != CamOutput::second_sheet) return true;
    const auto formulas = scene.cam->formulas();
    const DirectCam* const direct = formulas->direct();
    return direct != nullptr && !direct->drawing(scene.cam->middle()).pieces.empty();
}

constexpr const char* scene_file = "scene";

}  // namespace

std::vector<DownloadName> download_names() {
    std::vector<DownloadName> names = {{scene_file, "Scene (TOML)"}};
    for (const StudioFile& file : studio_files()) names.push_back({file.name, file.words});
    return names;
}

std::vector<std::string> downloads_of(const Scene& scene) {
    std::vector<std::string> names = {scene_file};
    for (const StudioFile& file : studio_files())
        if (has_file(scene, file.output)) names.push_back(file.name);
    return names;
}

StudioAnswer studio_download(const std::string& what, const StudioScene& given, const SolveControl& control) {
    if (what == scene_file)
        return {.type = "application/toml", .body = given.text, .file_name = "scene.toml"};
    const auto file = std::ranges::find(studio_files(), what, &StudioFile::name);
    if (file == studio_files().end() || !has_file(given.scene, file->output))
        throw InputError(fmt::format("this scene has no download of this name; allowed: {}",
                                     fmt::join(downloads_of(given.scene), ", ")));
    Solution solution = solve(given.scene, control);
    const bool made = solution.motion && solution.certificate.verdict != Verdict::infeasible;
    if (file->needs_motion && !made)
        throw InputError(fmt::format("{}: there is no motion to write: the scene is {}", file->file,
                                     name_of(solution.certificate.verdict)));
    if (solution.motion) add_forward_check(solution);
    const RunOrigin origin{"scene.toml", "camopt solve scene.toml", given.text};
    return {.type = file->type, .body = file->text(solution, origin), .file_name = file->file};
}

}  // namespace camopt::apps
