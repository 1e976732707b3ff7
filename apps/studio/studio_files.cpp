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

/// What scenes have the file.
enum class FileNeed : unsigned char { nothing, motion, plane_cam, disk, second_disk, milled };

using FileText = std::function<std::string(const Solution&, const RunOrigin&)>;

struct StudioFile {
    std::string name, words, file, type;
    FileNeed need = FileNeed::motion;
    FileText text;
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
    const FileNeed drawn = piece == 0 ? FileNeed::disk : FileNeed::second_disk;
    const FileNeed made = piece == 0 ? FileNeed::milled : FileNeed::second_disk;
    const auto sheet = [&](const std::string& format, const char* type) {
        std::string upper = format;
        std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return std::toupper(c); });
        const std::string name = fmt::format("drawing{}.{}", file, format);
        files.push_back({key + "drawing_" + format, fmt::format("Workshop drawing ({}){}", upper, end), name,
                         type, drawn, exported_text(name)});
    };
    if (workshop()->has_pdf()) sheet("pdf", "application/pdf");
    sheet("svg", "image/svg+xml");
    sheet("dxf", "image/vnd.dxf");
    const std::string solid = fmt::format("cam{}.step", file), program = fmt::format("cam{}.nc", file);
    if (workshop()->has_step())
        files.push_back({key + "step", "Solid or flanks (STEP)" + end, solid, "model/step", made,
                         [solid](const Solution& solution, const RunOrigin& origin) {
                             const std::string name = has_flanks(solution) ? "flanks.step" : solid;
                             return exported_file(solution, name, {.origin = origin});
                         }});
    files.push_back({key + "nc", "NC program" + end, program, "text/plain", made, exported_text(program)});
}

std::vector<StudioFile> make_files() {
    std::vector<StudioFile> files = {
        {"motion", "Motion (CSV)", "motion.csv", "text/csv", FileNeed::motion, exported_text("motion.csv")},
        {"cam", "Cam (CSV)", "cam.csv", "text/csv", FileNeed::plane_cam,
         [](const Solution& solution, const RunOrigin&) { return cam_view(solution, CamView::table); }}};
    if (workshop() != nullptr) {
        files.push_back({"dxf", "Cam (DXF)", "cam.dxf", "image/vnd.dxf", FileNeed::plane_cam,
                         exported_text(drawn_profile)});
        for (const std::size_t piece : {std::size_t{0}, std::size_t{1}}) add_piece(files, piece);
    }
    files.push_back({"result", "Result (JSON)", "result.json", "application/json", FileNeed::nothing,
                     exported_text("result.json")});
    files.push_back({"certificate", "Certificate (JSON)", "certificate.json", "application/json",
                     FileNeed::nothing, exported_text("certificate.json")});
    files.push_back({"report", "Report (HTML)", "report.html", "text/html", FileNeed::nothing,
                     exported_text("report.html")});
    if (workshop() != nullptr)
        for (const Controller& controller : workshop()->controllers())
            files.push_back({"plc_" + controller.key, "Controller: " + controller.name, controller.file,
                             "text/plain", FileNeed::motion, exported_text(controller.file)});
    return files;
}

const std::vector<StudioFile>& studio_files() {
    static const std::vector<StudioFile> files = make_files();
    return files;
}

bool has_file(const Scene& scene, FileNeed need) {
    if (need == FileNeed::nothing || need == FileNeed::motion) return true;
    if (!scene.cam) return false;
    const CamKind& kind = *cam_kind(scene.cam->type);  // a scene that was read has a kind
    switch (need) {
        case FileNeed::plane_cam:
            return kind.is_plane_curve;
        case FileNeed::disk:
            return kind.is_direct;
        case FileNeed::second_disk:
            return kind.is_direct && !scene.cam->formulas()->pieces(scene.cam->middle()).empty();
        default:
            return kind.is_direct || !kind.is_plane_curve;
    }
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
        if (has_file(scene, file.need)) names.push_back(file.name);
    return names;
}

StudioAnswer studio_download(const std::string& what, const StudioScene& given, const SolveControl& control) {
    if (what == scene_file)
        return {.type = "application/toml", .body = given.text, .file_name = "scene.toml"};
    const auto file = std::ranges::find(studio_files(), what, &StudioFile::name);
    if (file == studio_files().end() || !has_file(given.scene, file->need))
        throw InputError(fmt::format("this scene has no download of this name; allowed: {}",
                                     fmt::join(downloads_of(given.scene), ", ")));
    Solution solution = solve(given.scene, control);
    const bool made = solution.motion && solution.certificate.verdict != Verdict::infeasible;
    if (file->need != FileNeed::nothing && !made)
        throw InputError(fmt::format("{}: there is no motion to write: the scene is {}", file->file,
                                     name_of(solution.certificate.verdict)));
    if (solution.motion) add_forward_check(solution);
    const RunOrigin origin{"scene.toml", "camopt solve scene.toml", given.text};
    return {.type = file->type, .body = file->text(solution, origin), .file_name = file->file};
}

}  // namespace camopt::apps
