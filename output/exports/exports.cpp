// SPDX-License-Identifier: MIT
#include "output/exports/exports.hpp"

#include "core/errors.hpp"
#include "core/platform/files.hpp"
#include "core/text/text_file.hpp"
#include "core/version.hpp"
#include "output/cam/cam_files.hpp"
#include "output/chart/curve_chart.hpp"
#include "output/csv/motion_csv.hpp"
#include "output/disk/disk_export.hpp"
#include "output/disk/disk_solid.hpp"
#include "output/json/certificate_json.hpp"
#include "output/json/json_text.hpp"
#include "output/page/result_page.hpp"
#include "output/plc/plc_export.hpp"
#include "output/sheet/sheet_files.hpp"
#include "output/spatial/cam_export.hpp"
#include "output/toolpath/tool_path_svg.hpp"
#include "studies/spatial/spatial_forward_check.hpp"

#include <fmt/ranges.h>

#include <system_error>

namespace camopt {

namespace {

/// What follows "cam" and "drawing" in the names of the files of a piece.
std::string piece_suffix(std::size_t piece) {
    return piece == 0 ? "" : "_second";
}

std::string piece_title(const Solution& solution, std::size_t piece) {
    return export_title(solution) + piece_words(piece);
}

std::vector<ProfileShape> pieces_of(const Solution& solution) {
    const std::optional<ProfileShape> shape = delivered_shape(solution);
    return shape ? made_pieces(*shape) : std::vector<ProfileShape>{};
}

/// A folder of this process alone, for libraries that only write files; removed with its contents.
class PassingFolder {
 public:
    PassingFolder() = default;
    ~PassingFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    PassingFolder(const PassingFolder&) = delete;
    PassingFolder& operator=(const PassingFolder&) = delete;
    PassingFolder(PassingFolder&&) = delete;
    PassingFolder& operator=(PassingFolder&&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
    std::filesystem::path path_ = make_temporary_folder();
};

/// The flanks of a three-dimensional cam as the file of that name; kind: a member of CamExportOptions.
std::string flank_bytes(const Solution& solution, const char* name, bool CamExportOptions::*kind) {
    const PassingFolder folder;
    const MotionChain turn = whole_turn(solution);
    CamExportOptions options;
    options.*kind = true;
    options.title = export_title(solution);
    (void)write_cam_files(folder.path(), solved_flanks(solution),
                          follower_motion(turn, motion_scale(solution.scene)), options);
    return read_text_file(folder.path() / name);
}

std::string solid_bytes(const Plate& plate) {
    const PassingFolder folder;
    const std::filesystem::path file = folder.path() / "cam.step";
    write_step_solid(file, plate);
    return read_text_file(file);
}

/// Of the finishing pass: chords, printed digits and the stock that is left, with a tenth more as room for
/// the proof; of every move: how deep it may enter the finished cam. "path_mm": of the cutter's axis, at
/// either end of its working length.
std::string program_claims(const std::string& name, const Solution& solution, const CheckedProgram& program,
                           const NcWork& work, double stock) {
    constexpr double room = 1.1, printed = 2e-8;  // m
    const NcPoseCheck& poses = program.poses;
    const double rounding = poses.tip_rounding + poses.axis_rounding * work.task.blocks.working_length;
    const double chords = room * (program.chord_deviation + rounding) + printed + stock;
    const bool is_plane = solution.cam->cam.formulas->is_plane_curve();
    return export_check_json(solution, {{"camopt", version()},
                                        {"kind", "nc"},
                                        {"file", name + ".nc"},
                                        {"departure",
                                         {{is_plane ? "profile_mm" : "path_mm", millimetres_shown.of(chords)},
                                          {"gouge_mm", millimetres_shown.of(program.most_depth)}}}});
}

ExportedProgram checked(const std::string& name, const Solution& solution, const NcWork& work,
                        const Machine& machine, const NcChoice& choice) {
    PostProcessor post = generic_post(machine);
    if (!choice.post.empty()) post = read_post(choice.post, std::move(post));
    const CheckedProgram program = checked_program(machine, post, work);
    return {name,
            program.program.text,
            nc_check_text(program),
            tool_path_svg(program, work, machine, {work.job.title, shown_units(solution.scene).length}),
            program_claims(name, solution, program, work, choice.stock),
            program.fault()};
}

ExportedProgram program_of_flanks(const Solution& solution, const NcChoice& choice) {
    const CamFlanks cam = solved_flanks(solution);
    const MotionChain turn = whole_turn(solution);
    NcExportOptions options;
    static_cast<MillingOptions&>(options) = static_cast<const MillingOptions&>(choice);
    options.title = export_title(solution);
    options.cutter_diameter = choice.cutter_diameter;
    options.z_offset = choice.z_offset;
    options.rotary_speed = choice.rotary_speed;
    const auto machine = machine_for(cam, options.z_offset);
    return checked("cam", solution,
                   nc_work(cam, follower_motion(turn, motion_scale(solution.scene)), options), *machine,
                   choice);
}

ExportedProgram program_of_disk(const Solution& solution, const ProfileShape& shape, std::size_t piece,
                                const ExportOptions& choices) {
    const DrawingSpec drawing = drawing_of(solution, shape, choices.plate);
    DiskNcOptions options;
    static_cast<MillingOptions&>(options) = static_cast<const MillingOptions&>(choices.nc);
    options.title = piece_title(solution, piece);
    options.cutter_diameter = choices.nc.cutter_diameter;
    options.thickness = drawing.thickness.value();
    options.groove_depth = drawing.groove_depth;
    const auto machine = plane_milling_machine();
    return checked("cam" + piece_suffix(piece), solution, disk_nc_work(shape, options), *machine, choices.nc);
}

std::string sheet_bytes(const Sheet& sheet, std::string_view format) {
    if (format == "pdf") return sheet_pdf(sheet);
    if (format == "svg") return sheet_svg(sheet);
    if (format == "dxf") return sheet_dxf(sheet);
    throw InputError(fmt::format(R"(drawing: found "{}"; allowed: "pdf", "svg" or "dxf")", format));
}

/// The files of a solution and how each is made. What several files share is made once.
class Exports {
 public:
    Exports(const Solution& solution, const ExportOptions& options) : solution_(solution), options_(options) {
        add_reports();
        if (!solution.motion) return;
        add_motion();
        if (!solution.cam) return;
        if (solution.cam->cam.formulas->is_plane_curve()) add_plane();
        pieces_ = pieces_of(solution);
        for (std::size_t i = 0; i < pieces_.size(); ++i) add_piece(i);
        if (has_flanks(solution)) add_flanks();
    }

    Exports(const Exports&) = delete;  // rows refer to it
    Exports& operator=(const Exports&) = delete;
    Exports(Exports&&) = delete;
    Exports& operator=(Exports&&) = delete;
    ~Exports() = default;

    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const Row& row : rows_) all.push_back(row.name);
        return all;
    }

    [[nodiscard]] std::string bytes(std::string_view name) const {
        const auto row = std::ranges::find(rows_, name, &Row::name);
        if (row == rows_.end())
            throw InputError(fmt::format("file: found \"{}\"; allowed for this solution: {}", name,
                                         fmt::join(names(), ", ")));
        return row->make();
    }

 private:
    struct Row {
        std::string name;
        std::function<std::string()> make;
    };

    void add(std::string name, std::function<std::string()> make) {
        rows_.push_back({std::move(name), std::move(make)});
    }
    void add_reports() {
        add("report.html", [this] { return report_html(solution_, options_.origin); });
        add("report.md", [this] { return report_markdown(solution_, options_.origin); });
        add("result.json", [this] { return result_json(solution_, options_.origin); });
        add("certificate.json", [this] { return certificate_json(solution_.certificate); });
    }
    void add_motion() {
        add("motion.csv", [this] { return motion_csv(solution_); });
        add("motion.svg", [this] { return motion_svg(solution_); });
        for (const PlcFormat& format : plc_formats())
            for (const std::string& name : {format.file, format.text_file, plc_check_name(format)})
                if (!name.empty()) add(name, [this, &format, name] { return plc_bytes(format, name); });
    }
    void add_plane() {
        std::vector<std::string> names = {"profile.dxf", "profile.check.json"};
        for (const CamFile& file : cam_file_list(solution_)) names.push_back(file.name);
        for (const std::string& name : names)
            add(name, [this, name] {
                const std::vector<CamFile> files = cam_files(solution_, {.drawing = true});
                return std::ranges::find(files, name, &CamFile::name)->text;
            });
    }
    void add_piece(std::size_t piece) {
        for (const char* const format : {"pdf", "svg", "dxf"})
            add(fmt::format("drawing{}.{}", piece_suffix(piece), format), [this, piece, format] {
                return sheet_bytes(cam_sheets(solution_, options_.plate).at(piece), format);
            });
        const ProfileShape& shape = pieces_[piece];
        const std::string name = "cam" + piece_suffix(piece), title = piece_title(solution_, piece);
        const auto drawing = [this, &shape] { return drawing_of(solution_, shape, options_.plate); };
        add(name + ".step",
            [&shape, drawing, title] { return solid_bytes(disk_plate(shape, drawing(), title)); });
        add(name + ".stl",
            [&shape, drawing, title] { return stl_bytes(disk_mesh(shape, drawing()).mesh, title); });
        add_program(name, piece);
    }
    void add_flanks() {
        const std::pair<const char*, bool CamExportOptions::*> kinds[] = {
            {"flanks.csv", &CamExportOptions::csv},
            {"flanks.step", &CamExportOptions::step},
            {"groove.stl", &CamExportOptions::stl}};
        for (const auto& [name, kind] : kinds)
            add(name, [this, name = name, kind = kind] { return flank_bytes(solution_, name, kind); });
        add_program("cam", 0);
    }
    void add_program(const std::string& name, std::size_t piece) {
        add(name + ".nc", [this, piece] { return sound_program(piece).program; });
        add(name + ".check.json", [this, piece] { return sound_program(piece).claims; });
        add(name + "_nc_check.txt", [this, piece] { return programs().at(piece).check; });
        add(name + "_nc.svg", [this, piece] { return programs().at(piece).picture; });
    }
    [[nodiscard]] std::string plc_bytes(const PlcFormat& format, const std::string& name) const {
        constexpr int most_points = 100'000;
        if (const int points = options_.plc.points.value_or(2); points < 2 || points > most_points)
            throw InputError(fmt::format("points: found {}; allowed: 2 to {}", points, most_points));
        const PlcExport exported = plc_export(solution_, {format.key}, options_.plc);
        return std::ranges::find(exported.files, name, &PlcFile::name)->text;
    }
    [[nodiscard]] const ExportedProgram& sound_program(std::size_t piece) const {
        const ExportedProgram& program = programs().at(piece);
        if (!program.fault.empty())
            throw InputError(
                fmt::format("{}.nc: the NC program is refused: {}", program.name, program.fault));
        return program;
    }
    [[nodiscard]] const std::vector<ExportedProgram>& programs() const {
        if (!programs_) programs_ = nc_programs(solution_, options_);
        return *programs_;
    }

    const Solution& solution_;
    const ExportOptions& options_;
    std::vector<ProfileShape> pieces_;
    std::vector<Row> rows_;
    mutable std::optional<std::vector<ExportedProgram>> programs_;
};

}  // namespace

const char* piece_words(std::size_t piece) {
    return piece == 0 ? "" : ", second disk";
}

std::string export_title(const Solution& solution) {
    return solution.scene.title.empty() ? "cam" : solution.scene.title;
}

std::vector<ExportedProgram> nc_programs(const Solution& solution, const ExportOptions& options) {
    if (solution.cam && has_flanks(solution)) return {program_of_flanks(solution, options.nc)};
    const std::vector<ProfileShape> pieces = pieces_of(solution);
    if (pieces.empty())
        throw InputError(
            "NC program: found no cam that is milled; allowed: a disk cam or a "
            "three-dimensional one, with a motion");
    std::vector<ExportedProgram> programs;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        programs.push_back(program_of_disk(solution, pieces[i], i, options));
    return programs;
}

std::vector<FolderFile> drawing_files(const Solution& solution, std::string_view format,
                                      const CamSheetOptions& options) {
    std::vector<FolderFile> files;
    for (const Sheet& sheet : cam_sheets(solution, options))
        files.push_back(
            {fmt::format("drawing{}.{}", piece_suffix(files.size()), format), sheet_bytes(sheet, format)});
    return files;
}

std::vector<std::string> export_names(const Solution& solution) {
    return Exports(solution, {}).names();
}

std::string exported_file(const Solution& solution, std::string_view name, const ExportOptions& options) {
    return Exports(solution, options).bytes(name);
}

std::vector<std::filesystem::path> write_exports(const std::filesystem::path& folder,
                                                 const Solution& solution, std::span<const std::string> names,
                                                 const ExportOptions& options) {
    const Exports exports(solution, options);
    std::vector<FolderFile> files;
    for (const std::string& name : names) files.push_back({name, exports.bytes(name)});
    FolderUpdate update(folder);
    for (const FolderFile& file : files) update.write(file.name, file.text);
    return update.finish();
}

}  // namespace camopt
