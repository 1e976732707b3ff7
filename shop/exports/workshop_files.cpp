// SPDX-License-Identifier: MIT
#include "shop/exports/workshop_files.hpp"

#include "core/errors.hpp"
#include "core/platform/files.hpp"
#include "core/text/text_file.hpp"
#include "core/version.hpp"
#include "report/cam/cam_files.hpp"
#include "report/exports/workshop.hpp"
#include "report/json/json_text.hpp"
#include "report/spatial/flank_surfaces.hpp"
#include "report/spatial/indexing_body.hpp"
#include "shop/disk/disk_export.hpp"
#include "shop/disk/disk_solid.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "shop/plc/plc_export.hpp"
#include "shop/sheet/sheet_files.hpp"
#include "shop/spatial/cam_export.hpp"
#include "shop/spatial/drum_sheet.hpp"
#include "shop/step/step_file.hpp"
#include "shop/toolpath/tool_path_svg.hpp"
#include "studies/spatial/spatial_forward_check.hpp"

#include <fmt/format.h>

#include <map>
#include <system_error>

namespace camopt {

namespace {

/// What follows "cam" and "drawing" in the names of the files of a piece.
std::string piece_suffix(std::size_t piece) {
    return piece == 0 ? "" : "_second";
}

std::string piece_title(const Solution& solution, std::size_t piece) {
    return export_title(solution) + (piece == 0 ? "" : ", second disk");
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

/// The flanks of a three-dimensional cam as files of one kind: a member of CamExportOptions.
std::vector<FolderFile> flank_files(const Solution& solution, const WorkshopOptions& options,
                                    bool CamExportOptions::*kind) {
    constexpr int flank_points = 361;
    const PassingFolder folder;
    const MotionChain turn = whole_turn(solution);
    CamExportOptions wanted;
    wanted.*kind = true;
    wanted.title = export_title(solution);
    wanted.sampling = {options.sections, options.points.value_or(flank_points), 0.0, 0.0};
    std::vector<FolderFile> files;
    for (const auto& path : write_cam_files(folder.path(), solved_flanks(solution),
                                            follower_motion(turn, motion_scale(solution.scene)), wanted))
        files.push_back({path.filename().string(), read_text_file(path)});
    return files;
}

/// "302972 mm3", "18.4885 in3".
std::string volume_text(LengthUnit unit, double volume) {
    return fmt::format("{:.6g} {}3", volume / std::pow(metres_of(unit), 3), name_of(unit));
}

MadeFile made_solid(const std::string& file, const Plate& plate, LengthUnit unit) {
    const PassingFolder folder;
    const double volume = write_step_solid(folder.path() / file, plate);
    return {read_text_file(folder.path() / file),
            fmt::format("  {}: a solid of {}\n", file, volume_text(unit, volume))};
}

MadeFile made_mesh(const std::string& file, const DiskMesh& solid, const std::string& title,
                   LengthUnit unit) {
    return {
        stl_bytes(solid.mesh, title),
        fmt::format(
            "  {}: {} triangles, at most {:.3g} um from the cam; {}, {:.2g} of it {} than the cam's own\n",
            file, solid.mesh.triangles.size(), solid.deviation / unit_named<"um">.factor,
            volume_text(unit, solid.volume), std::abs(solid.volume / solid.exact - 1.0),
            solid.volume < solid.exact ? "less" : "more")};
}

/// A program's file without its suffix, and the key of what it departs from.
struct ProgramName {
    std::string file;
    const char* departure;
};

/// Of the finishing pass, from the surface that leaves the stock: chords and printed digits, with a tenth
/// more as room for the proof; of every move: how deep it may enter the finished cam. "path_mm": of the
/// cutter's axis, at either end of its working length.
std::string program_claims(const ProgramName& name, const Solution& solution, const CheckedProgram& program,
                           const NcWork& work) {
    constexpr double room = 1.1, printed = 2e-8;  // m
    const NcPoseCheck& poses = program.poses;
    const double rounding = poses.tip_rounding + poses.axis_rounding * work.task.blocks.working_length;
    const double chords = room * (program.chord_deviation + rounding) + printed;
    return export_check_json(solution, {{"camopt", version()},
                                        {"kind", "nc"},
                                        {"file", name.file + ".nc"},
                                        {"departure",
                                         {{name.departure, millimetres_shown.of(chords)},
                                          {"gouge_mm", millimetres_shown.of(program.most_depth)}}}});
}

ExportedProgram checked(const ProgramName& name, const Solution& solution, const NcWork& work,
                        const Machine& machine, const NcChoice& choice) {
    PostProcessor post = generic_post(machine);
    if (!choice.post.empty()) post = read_post(choice.post, std::move(post));
    const CheckedProgram program = checked_program(machine, post, work);
    return {name.file,
            program.program.text,
            nc_check_text(program),
            tool_path_svg(program, work, machine, {work.job.title, shown_units(solution.scene).length}),
            program_claims(name, solution, program, work),
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
    return checked({"cam", "path_mm"}, solution,
                   nc_work(cam, follower_motion(turn, motion_scale(solution.scene)), options), *machine,
                   choice);
}

ExportedProgram program_of_disk(const Solution& solution, const ProfileShape& shape, std::size_t piece,
                                const WorkshopOptions& choices) {
    const DrawingSpec drawing = drawing_of(solution, shape, choices.plate);
    DiskNcOptions options;
    static_cast<MillingOptions&>(options) = static_cast<const MillingOptions&>(choices.nc);
    options.title = piece_title(solution, piece);
    options.cutter_diameter = choices.nc.cutter_diameter;
    options.thickness = drawing.thickness.value();
    options.groove_depth = drawing.groove_depth;
    const auto machine = plane_milling_machine();
    return checked({"cam" + piece_suffix(piece), "profile_mm"}, solution, disk_nc_work(shape, options),
                   *machine, choices.nc);
}

std::string sheet_bytes(const Sheet& sheet, std::string_view format) {
    if (format == "pdf") return sheet_pdf(sheet);
    if (format == "svg") return sheet_svg(sheet);
    if (format == "dxf") return sheet_dxf(sheet);
    throw InputError(fmt::format(R"(drawing: found "{}"; allowed: "pdf", "svg" or "dxf")", format));
}

/// The shop's files of a solution and how each is made. What several files share is made once.
class WorkshopFiles : public std::enable_shared_from_this<WorkshopFiles> {
 public:
    WorkshopFiles(const Solution& solution, const ExportOptions& options)
        : solution_(solution), options_(workshop_options(options.settings)) {}

    [[nodiscard]] std::vector<ExportFile> all() {
        if (!solution_.motion) return {};
        add_controllers();
        if (!solution_.cam) return std::move(files_);
        if (solution_.cam->cam.formulas->plane() != nullptr) add_plane();
        pieces_ = pieces_of(solution_);
        for (std::size_t i = 0; i < pieces_.size(); ++i) add_piece(i);
        if (has_flanks(solution_)) add_flanks();
        return std::move(files_);
    }

 private:
    using Self = const WorkshopFiles&;

    /// Keeps this alive as long as its files.
    template <class Make>
    void add(std::string name, Make make) {
        files_.push_back({std::move(name), [self = shared_from_this(), make] { return make(*self); }});
    }
    /// One of the files that `make` gives together, once for all of the group.
    template <class Make>
    void add_of(const std::string& group, const std::string& name, Make make) {
        add(name, [group, name, make](Self self) {
            auto made = self.groups_.find(group);
            if (made == self.groups_.end()) made = self.groups_.emplace(group, make(self)).first;
            return std::ranges::find(made->second, name, &FolderFile::name)->text;
        });
    }

    void add_controllers() {
        for (const PlcFormat& format : plc_formats()) {
            std::vector<std::string> names = format.files();
            names.push_back(plc_check_name(format));
            for (const std::string& name : names)
                add_of(format.key, name, [&format](Self self) {
                    return plc_export(self.solution_, {format.key}, {self.options_.points}).files;
                });
        }
    }
    void add_plane() {
        for (const char* const name : {drawn_profile, drawn_profile_check})
            add_of("dxf", name,
                   [](Self self) { return dxf_files(self.solution_, self.options_.dxf_tolerance); });
    }
    void add_piece(std::size_t piece) {
        const std::string name = "cam" + piece_suffix(piece), title = piece_title(solution_, piece);
        add(name + ".stl", [piece, title, file = name + ".stl"](Self self) {
            return made_mesh(
                file, disk_mesh(self.pieces_[piece], self.drawing(piece), {.points = self.options_.points}),
                title, self.solution_.scene.length_unit);
        });
        add(name + ".step", [piece, title, file = name + ".step"](Self self) {
            return made_solid(file, disk_plate(self.pieces_[piece], self.drawing(piece), title),
                              self.solution_.scene.length_unit);
        });
        add_sheet(piece);
        add_program(name, piece);
    }
    void add_sheet(std::size_t piece) {
        for (const char* const format : {"pdf", "svg", "dxf"})
            add(fmt::format("drawing{}.{}", piece_suffix(piece), format),
                [piece, format](Self self) { return sheet_bytes(self.sheets().at(piece), format); });
    }
    void add_flanks() {
        const auto flanks = [this](const char* kind, const char* name, bool CamExportOptions::*wanted) {
            add_of(kind, name,
                   [wanted](Self self) { return flank_files(self.solution_, self.options_, wanted); });
        };
        const MotionChain turn = whole_turn(solution_);
        const FollowerMotion motion = follower_motion(turn, motion_scale(solution_.scene));
        const bool whole = indexes(solved_flanks(solution_), motion) || groove_closes(motion);
        flanks("csv", "flanks.csv", &CamExportOptions::csv);
        flanks("step", "flanks.step", &CamExportOptions::step);
        flanks("stl", "groove.stl", &CamExportOptions::stl);
        if (whole) flanks("stl", "cam.stl", &CamExportOptions::stl);
        flanks("picture", "cam.svg", &CamExportOptions::picture);
        add_sheet(0);
        add_program("cam", 0);
    }
    void add_program(const std::string& name, std::size_t piece) {
        add(name + ".nc", [piece](Self self) { return self.sound_program(piece).program; });
        add(name + ".check.json", [piece](Self self) { return self.sound_program(piece).claims; });
        add(name + "_nc_check.txt", [piece](Self self) { return self.programs().at(piece).check; });
        add(name + "_nc.svg", [piece](Self self) { return self.programs().at(piece).picture; });
    }
    [[nodiscard]] DrawingSpec drawing(std::size_t piece) const {
        return drawing_of(solution_, pieces_[piece], options_.plate);
    }
    [[nodiscard]] const std::vector<Sheet>& sheets() const {
        if (sheets_) return *sheets_;
        if (has_flanks(solution_)) {
            const MotionChain turn = whole_turn(solution_);
            DrawingSpec drawing = solution_.scene.drawing.value_or(DrawingSpec{});
            if (options_.plate.bore) drawing.bore = options_.plate.bore;
            sheets_ = {drum_sheet(solution_, solved_flanks(solution_),
                                  follower_motion(turn, motion_scale(solution_.scene)), drawing)};
        } else {
            sheets_ = cam_sheets(solution_, options_.plate);
        }
        return *sheets_;
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
    WorkshopOptions options_;
    std::vector<ProfileShape> pieces_;
    std::vector<ExportFile> files_;
    mutable std::map<std::string, std::vector<FolderFile>> groups_;
    mutable std::optional<std::vector<Sheet>> sheets_;
    mutable std::optional<std::vector<ExportedProgram>> programs_;
};

Controller controller_of(const PlcFormat& format) {
    return {format.key, format.controller, format.file};
}

std::vector<Controller> controllers() {
    std::vector<Controller> all;
    for (const PlcFormat& format : plc_formats()) all.push_back(controller_of(format));
    return all;
}

}  // namespace

std::string export_title(const Solution& solution) {
    return solution.scene.title.empty() ? "cam" : solution.scene.title;
}

std::vector<ExportedProgram> nc_programs(const Solution& solution, const WorkshopOptions& options) {
    if (solution.cam && has_flanks(solution)) return {program_of_flanks(solution, options.nc)};
    const std::vector<ProfileShape> pieces = pieces_of(solution);
    if (pieces.empty())
        throw InputError(
            "NC program: found no cam that is milled; allowed: a disk cam, a linear one or a "
            "three-dimensional one, with a motion");
    std::vector<ExportedProgram> programs;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        programs.push_back(program_of_disk(solution, pieces[i], i, options));
    return programs;
}

const Workshop* workshop() {
    static const Workshop shop = {[](const Solution& solution, const ExportOptions& options) {
                                      return std::make_shared<WorkshopFiles>(solution, options)->all();
                                  },
                                  [] { return workshop_rows(); },
                                  [](const View& view) { return dxf_files(view); },
                                  controllers,
                                  [](std::string_view key) { return controller_of(plc_format(key)); },
                                  plc_files,
                                  refuse_too_few_elements,
                                  pdf_available,
                                  step_available};
    return &shop;
}

}  // namespace camopt
