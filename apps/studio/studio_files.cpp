// SPDX-License-Identifier: MIT
// The files of a scene that the studio's page may ask for: one row each.
#include "apps/studio/request_room.hpp"
#include "apps/studio/studio_page.hpp"
#include "core/errors.hpp"
#include "core/text/text_file.hpp"
#include "output/csv/motion_csv.hpp"
#include "output/disk/disk_export.hpp"
#include "output/disk/disk_solid.hpp"
#include "output/json/result_json.hpp"
#include "output/page/page_html.hpp"
#include "output/plc/plc_export.hpp"
#include "output/report/cam_files.hpp"
#include "output/sheet/cam_sheet.hpp"
#include "output/sheet/sheet_files.hpp"
#include "output/spatial/cam_export.hpp"
#include "output/surface/step/step_file.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "studies/checked/checked_cam.hpp"
#include "studies/solve/solve.hpp"
#include "studies/spatial/spatial_forward_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <system_error>
#include <utility>

namespace camopt::apps {

namespace {

/// What scenes have the file.
enum class FileNeed : unsigned char { nothing, motion, plane_cam, disk, second_disk, milled };

struct StudioFile {
    std::string name, words, file, type;
    FileNeed need = FileNeed::motion;
    std::function<std::string(const Solution& solution, const RunOrigin& origin)> text;
};

std::string title_of(const Solution& solution) {
    return solution.scene.title.empty() ? "cam" : solution.scene.title;
}

/// The cam, or the second disk on its shaft.
ProfileShape piece_of(const Solution& solution, std::size_t piece) {
    const std::optional<ProfileShape> shape = delivered_shape(solution);
    if (!shape) throw InputError("this file is for disk cams");
    const std::vector<ProfileShape> pieces = made_pieces(*shape);
    if (piece >= pieces.size()) throw InputError("this cam is one disk");
    return pieces[piece];
}

std::string sheet_text(const Solution& solution, std::size_t piece, std::string (*text)(const Sheet&)) {
    const std::vector<Sheet> sheets = cam_sheets(solution);
    if (piece >= sheets.size()) throw InputError("this cam is one disk");
    return text(sheets[piece]);
}

/// A folder of this user alone, for a library that only writes files; gone with what is in it.
class PassingFolder {
 public:
    PassingFolder() : path_(std::filesystem::temp_directory_path() / ("camopt-" + random_token())) {
        std::filesystem::create_directory(path_);
        std::filesystem::permissions(path_, std::filesystem::perms::owner_all);
    }
    ~PassingFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    PassingFolder(const PassingFolder&) = delete;
    PassingFolder& operator=(const PassingFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path path_;
};

std::string step_text(const Solution& solution, std::size_t piece) {
    const PassingFolder folder;
    if (has_flanks(solution)) {
        CamExportOptions options;
        options.step = true;
        options.title = title_of(solution);
        const MotionChain turn = whole_turn(solution);
        const FollowerMotion motion = follower_motion(turn, motion_scale(solution.scene));
        return read_text_file(
            write_cam_files(folder.path(), solved_flanks(solution), motion, options).front());
    }
    const ProfileShape shape = piece_of(solution, piece);
    const std::filesystem::path file = folder.path() / "cam.step";
    const std::string name = title_of(solution) + (piece == 0 ? "" : ", second disk");
    write_step_solid(file, disk_plate(shape, drawing_of(solution, shape, {}), name));
    return read_text_file(file);
}

std::string checked_text(const Machine& machine, const NcWork& work) {
    const CheckedProgram program = checked_program(machine, generic_post(machine), work);
    if (const std::string fault = program.fault(); !fault.empty())
        throw InputError("the NC program is refused: " + fault);
    return program.program.text;
}

/// With the choices that `camopt export --nc` makes.
std::string nc_text(const Solution& solution, std::size_t piece) {
    if (has_flanks(solution)) {
        const CamFlanks cam = solved_flanks(solution);
        const MotionChain turn = whole_turn(solution);
        NcExportOptions options;
        options.title = title_of(solution);
        const auto machine = machine_for(cam, options.z_offset);
        return checked_text(*machine,
                            nc_work(cam, follower_motion(turn, motion_scale(solution.scene)), options));
    }
    const ProfileShape shape = piece_of(solution, piece);
    const DrawingSpec drawing = drawing_of(solution, shape, {});
    DiskNcOptions options;
    options.title = title_of(solution) + (piece == 0 ? "" : ", second disk");
    options.thickness = drawing.thickness.value();
    options.groove_depth = drawing.groove_depth;
    const auto machine = plane_milling_machine();
    return checked_text(*machine, disk_nc_work(shape, options));
}

/// Drawing, solid and program of one disk.
void add_piece(std::vector<StudioFile>& files, std::size_t piece) {
    const std::string key = piece == 0 ? "" : "second_", end = piece == 0 ? "" : ", second disk";
    const std::string file = piece == 0 ? "" : "_second";
    const FileNeed drawn = piece == 0 ? FileNeed::disk : FileNeed::second_disk;
    const FileNeed made = piece == 0 ? FileNeed::milled : FileNeed::second_disk;
    const auto sheet = [&](const std::string& format, const char* type, std::string (*text)(const Sheet&)) {
        std::string upper = format;
        std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return std::toupper(c); });
        files.push_back({key + "drawing_" + format, fmt::format("Workshop drawing ({}){}", upper, end),
                         fmt::format("drawing{}.{}", file, format), type, drawn,
                         [piece, text](const Solution& solution, const RunOrigin&) {
                             return sheet_text(solution, piece, text);
                         }});
    };
    if (pdf_available()) sheet("pdf", "application/pdf", sheet_pdf);
    sheet("svg", "image/svg+xml", sheet_svg);
    sheet("dxf", "image/vnd.dxf", sheet_dxf);
    if (step_available())
        files.push_back({key + "step", "Solid or flanks (STEP)" + end, fmt::format("cam{}.step", file),
                         "model/step", made, [piece](const Solution& solution, const RunOrigin&) {
                             return step_text(solution, piece);
                         }});
    files.push_back(
        {key + "nc", "NC program" + end, fmt::format("cam{}.nc", file), "text/plain", made,
         [piece](const Solution& solution, const RunOrigin&) { return nc_text(solution, piece); }});
}

std::vector<StudioFile> make_files() {
    std::vector<StudioFile> files = {
        {"motion", "Motion (CSV)", "motion.csv", "text/csv", FileNeed::motion,
         [](const Solution& solution, const RunOrigin&) { return motion_csv(solution); }},
        {"cam", "Cam (CSV)", "cam.csv", "text/csv", FileNeed::plane_cam,
         [](const Solution& solution, const RunOrigin&) { return cam_view(solution, CamView::table); }},
        {"dxf", "Cam (DXF)", "cam.dxf", "image/vnd.dxf", FileNeed::plane_cam,
         [](const Solution& solution, const RunOrigin&) { return cam_view(solution, CamView::drawing); }}};
    for (const std::size_t piece : {std::size_t{0}, std::size_t{1}}) add_piece(files, piece);
    files.push_back(
        {"result", "Result (JSON)", "result.json", "application/json", FileNeed::nothing, result_json});
    files.push_back(
        {"report", "Report (HTML)", "report.html", "text/html", FileNeed::nothing,
         [](const Solution& solution, const RunOrigin& origin) { return report_html(solution, origin); }});
    for (const PlcFormat& format : plc_formats())
        files.push_back({"plc_" + format.key, "Controller: " + format.controller, format.file, "text/plain",
                         FileNeed::motion, [key = format.key](const Solution& solution, const RunOrigin&) {
                             return plc_export(solution, {key}, {}).files.front().text;
                         }});
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
    if (file->need != FileNeed::nothing && !solution.motion)
        throw InputError(fmt::format("{}: there is no motion to write: the scene is {}", file->file,
                                     name_of(solution.certificate.verdict)));
    if (solution.motion) add_forward_check(solution);
    const RunOrigin origin{"scene.toml", "camopt solve scene.toml", given.text};
    return {.type = file->type, .body = file->text(solution, origin), .file_name = file->file};
}

}  // namespace camopt::apps
