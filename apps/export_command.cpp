// SPDX-License-Identifier: MIT
// camopt export: the cam of a scene, which is optimised, or of a result folder, which is used as it is:
// points, surfaces, drawings, solids, a picture, the NC program with its check. Of its motion, with or
// without a cam: a uniform table, electronic cams.
#include "apps/commands.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "core/unit.hpp"
#include "output/cam/cam_files.hpp"
#include "output/csv/lobe_csv.hpp"
#include "output/csv/motion_csv.hpp"
#include "output/disk/disk_solid.hpp"
#include "output/exports/exports.hpp"
#include "output/plc/plc_export.hpp"
#include "output/plc/table_check.hpp"
#include "output/sheet/sheet_files.hpp"
#include "output/solve/solution_document.hpp"
#include "output/spatial/cam_export.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/spatial/spatial_forward_check.hpp"

#include <fmt/format.h>

namespace camopt::apps {

namespace {

constexpr int flank_points = 361;           // over the turn
constexpr const char* first_piece = "cam";  // the files of a cam, or of its first disk

/// What was written, and what the check of a program found.
struct Exported {
    std::string text;
    std::vector<std::filesystem::path> written;
    std::string fault;  ///< why the program was not written; empty: it was, or none was asked for
};

/// What needs no cam.
bool wants_only_motion(const ExportRequest& request) {
    const bool cam =
        request.stl || request.step || request.picture || request.dxf || request.nc || !request.sheet.empty();
    return !cam && (request.csv || !request.lobe.empty() || !request.plc.empty());
}

/// The types of cams that have a workshop drawing: "disk".
std::string drawn_types() {
    std::vector<std::string_view> types;
    for (const CamKind& kind : cam_kinds())
        if (kind.is_direct) types.emplace_back(kind.type);
    return quoted_choices(types);
}

[[noreturn]] void refuse_drawing(const ExportRequest& request, const std::string& type) {
    throw InputError(
        fmt::format("{}: --drawing: found with a cam of type \"{}\"; allowed: with cam.type = {}",
                    request.scene, type, drawn_types()));
}

/// Throws where the cam of this scene has no such files.
void check_wishes(const ExportRequest& request, const Scene& scene) {
    const std::optional<CamSpec>& cam = scene.cam;
    if ((request.step_deg || request.digits) && !request.csv && request.lobe.empty())
        throw InputError(fmt::format("{}: found without a table; allowed: with --csv or --lobe",
                                     request.step_deg ? "--step-deg" : "--digits"));
    if (!cam) {
        if (wants_only_motion(request)) return;
        throw InputError(fmt::format(
            "{}: export writes --csv, --lobe and --plc of a motion; the rest is for cams, and this "
            "scene has none",
            request.scene));
    }
    if (request.sheet == "pdf") require_pdf();
    if (!cam_kind(cam->type)->is_plane_curve) {
        if (!request.sheet.empty()) refuse_drawing(request, cam->type);
        if (!request.dxf) return;
        throw InputError(fmt::format("{}: --dxf: found with a cam of type \"{}\", which is not a plane curve",
                                     request.scene, cam->type));
    }
    const bool direct = cam->formulas()->is_direct();
    if (!direct && !request.sheet.empty()) refuse_drawing(request, cam->type);
    if (!direct && (request.step || request.stl || request.nc))
        throw InputError(fmt::format("{}: of a cam of type \"{}\" export writes --csv, --dxf and --picture",
                                     request.scene, cam->type));
}

void write_program(const ExportedProgram& program, FolderUpdate& folder, Exported& result) {
    result.text +=
        (program.name == first_piece ? "" : fmt::format("\n{}.nc\n", program.name)) + program.check;
    if (result.fault.empty()) result.fault = program.fault;
    folder.remove_earlier(program.name + ".nc");  // it does not go with this check
    folder.remove_earlier(program.name + ".check.json");
    if (program.fault.empty()) {
        folder.write(program.name + ".nc", program.program);
        folder.write(program.name + ".check.json", program.claims);
    }
    folder.write(program.name + "_nc_check.txt", program.check);
    folder.write(program.name + "_nc.svg", program.picture);
}

/// The same of all cams.
void set_safety(const ExportRequest& request, MillingOptions& options) {
    const auto metres = [](const std::optional<double>& mm) -> std::optional<double> {
        if (!mm) return std::nullopt;
        return *mm * units::millimetre;
    };
    options.blank = {metres(request.blank_diameter_mm), metres(request.blank_from_mm),
                     metres(request.blank_to_mm), request.blank_allowance_mm * units::millimetre};
    if (options.blank.radius) *options.blank.radius *= 0.5;
    options.clearance = request.clearance_mm * units::millimetre;
    options.safe_distance = request.safe_mm * units::millimetre;
    options.gouge_tolerance = request.gouge_mm * units::millimetre;
    MillingChoice& milling = options.milling;
    milling.step_over = metres(request.rough_step_over_mm);
    milling.step_down = metres(request.rough_step_down_mm);
    milling.finish_allowance = metres(request.finish_allowance_mm);
    milling.full_depth = request.full_depth;
    if (!request.direction.empty())
        milling.direction =
            request.direction == "climb" ? MillingDirection::climb : MillingDirection::conventional;
    milling.spindle =
        request.spindle == "clockwise" ? SpindleSense::clockwise : SpindleSense::counterclockwise;
    milling.tool_number = request.tool_number;
    milling.compensation =
        request.compensation == "control" ? CompensationWords::control : CompensationWords::none;
    milling.compensation_register = request.compensation_register;
    milling.lead_radius = metres(request.lead_mm);
    milling.ramp_angle = request.ramp_deg * units::degree;
}

CamSheetOptions sheet_options(const ExportRequest& request) {
    CamSheetOptions options;
    if (request.bore_mm) options.bore = *request.bore_mm * units::millimetre;
    if (request.thickness_mm) options.thickness = *request.thickness_mm * units::millimetre;
    return options;
}

NcChoice nc_choice(const ExportRequest& request) {
    NcChoice choice;
    if (request.cutter_mm) choice.cutter_diameter = *request.cutter_mm * units::millimetre;
    choice.stock = request.stock_mm * units::millimetre;
    choice.z_offset = request.z_offset_mm * units::millimetre;
    choice.feed = request.feed_mm_min * units::millimetre / units::minute;
    choice.rotary_speed = request.rotary_deg_s * units::degree;
    choice.spindle_rpm = request.spindle_rpm;
    choice.chord_tolerance = request.chord_mm * units::millimetre;
    choice.post = request.post;
    set_safety(request, choice);
    return choice;
}

void export_programs(const ExportRequest& request, const Solution& solution, FolderUpdate& folder,
                     Exported& result) {
    if (!request.nc) return;
    ExportOptions options;
    options.plate = sheet_options(request);
    options.nc = nc_choice(request);
    for (const ExportedProgram& program : nc_programs(solution, options))
        write_program(program, folder, result);
}

void export_flanks(const ExportRequest& request, const Solution& solution, FolderUpdate& folder) {
    const CamFlanks cam = solved_flanks(solution);
    const MotionChain turn = whole_turn(solution);
    const FollowerMotion motion = follower_motion(turn, motion_scale(solution.scene));
    CamExportOptions options;
    options.csv = request.csv;
    options.stl = request.stl;
    options.step = request.step;
    options.picture = request.picture;
    options.sampling = {request.sections, request.points.value_or(flank_points), 0.0, 0.0};
    options.title = export_title(solution);
    for (const std::filesystem::path& file : write_cam_files(folder.aside(), cam, motion, options))
        folder.add(file.filename().string());
}

bool is_wanted(const ExportRequest& request, CamView view) {
    if (view == CamView::table) return request.csv;
    if (view == CamView::picture) return request.picture;
    return view == CamView::drawing && request.dxf;
}

/// What every plane cam has.
void export_plane(const ExportRequest& request, const Solution& solution, FolderUpdate& folder) {
    if (!request.csv && !request.dxf && !request.picture) return;
    for (const CamFile& file : cam_files(solution, {.points = request.points, .drawing = request.dxf}))
        if (is_wanted(request, file.view)) folder.write(file.name, file.text);
}

/// "302972 mm3", "18.4885 in3".
std::string volume_text(LengthUnit unit, double volume) {
    return fmt::format("{:.6g} {}3", volume / std::pow(metres_of(unit), 3), name_of(unit));
}

std::string mesh_text(const std::string& file, const DiskMesh& solid, LengthUnit unit) {
    return fmt::format(
        "  {}: {} triangles, at most {:.3g} um from the cam; {}, {:.2g} of it {} than the cam's own\n", file,
        solid.mesh.triangles.size(), solid.deviation / unit_named<"um">.factor,
        volume_text(unit, solid.volume), std::abs(solid.volume / solid.exact - 1.0),
        solid.volume < solid.exact ? "less" : "more");
}

/// name: of its files.
void export_piece(const ExportRequest& request, const Solution& solution, const ProfileShape& shape,
                  const std::string& name, FolderUpdate& folder, Exported& result) {
    const DrawingSpec drawing = drawing_of(solution, shape, sheet_options(request));
    const std::string title = export_title(solution) + piece_words(name == first_piece ? 0 : 1);
    if (request.stl) {
        DiskMeshOptions mesh;
        mesh.points = request.points;
        const DiskMesh solid = disk_mesh(shape, drawing, mesh);
        folder.write(name + ".stl", stl_bytes(solid.mesh, title));
        result.text += mesh_text(name + ".stl", solid, solution.scene.length_unit);
    }
    if (request.step) {
        const double volume =
            write_step_solid(folder.aside() / (name + ".step"), disk_plate(shape, drawing, title));
        folder.add(name + ".step");
        result.text +=
            fmt::format("  {}.step: a solid of {}\n", name, volume_text(solution.scene.length_unit, volume));
    }
}

void export_disk(const ExportRequest& request, const Solution& solution, FolderUpdate& folder,
                 Exported& result) {
    const std::optional<ProfileShape> shape = delivered_shape(solution);
    if (!shape) return;
    const std::vector<ProfileShape> pieces = made_pieces(*shape);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        export_piece(request, solution, pieces[i], i == 0 ? first_piece : "cam_second", folder, result);
    if (!request.sheet.empty())
        for (const FolderFile& file : drawing_files(solution, request.sheet, sheet_options(request)))
            folder.write(file.name, file.text);
}

/// What every motion has, with or without a cam.
void export_motion(const ExportRequest& request, const Solution& solution, FolderUpdate& folder,
                   Exported& result) {
    if (!solution.motion) return;
    if (request.csv) {
        UniformTableOptions options{request.points, request.step_deg, {}, request.digits};
        if (request.step_deg) options.rows.reset();
        if (!request.columns.empty()) options.columns = column_names(request.columns);
        const UniformTable table = uniform_table(solution, options);
        const TableCheck check = table_check(solution, table);
        folder.write("table.csv", table.text);
        folder.write("table.check.json", check.json);
        result.text += fmt::format("\nTable: {}\n{}", table.words(), check.words);
    }
    if (!request.lobe.empty()) {
        const LengthUnit unit = request.lobe == "in" ? LengthUnit::inch : LengthUnit::millimetre;
        folder.write("lobe.csv", lobe_csv(solution, {unit, request.step_deg.value_or(1.0), request.digits}));
    }
    if (!request.plc.empty()) {
        const PlcExport exported = plc_export(solution, request.plc, {request.points});
        for (const PlcFile& file : exported.files) folder.write(file.name, file.text);
        result.text += exported.text;
    }
}

}  // namespace

std::vector<std::string> drawing_formats() {
    return {"svg", "pdf", "dxf"};
}

ExitCode export_command(const ExportRequest& request) {
    prepare_folder(request.out);
    const InterruptWatch watch;  // until the files are written
    Solution solution = solved_or_read(request.scene, with_solver(request.settings, request.solver),
                                       [&](const Scene& scene) { check_wishes(request, scene); });
    // A prescribed motion that violates a limit is shown, not made.
    if (solution.certificate.verdict == Verdict::infeasible) withdraw_motion(solution);
    Exported exported;
    FolderUpdate folder(request.out);
    export_motion(request, solution, folder, exported);
    if (solution.cam) {
        if (has_flanks(solution)) export_flanks(request, solution, folder);
        export_plane(request, solution, folder);
        export_disk(request, solution, folder, exported);
        export_programs(request, solution, folder, exported);
    }
    exported.written = folder.finish();
    show_in(solution.scene, request.units);  // the files are written: for the words alone
    print(summary_text(solution) + written_lines(exported.written) + exported.text);
    if (!exported.fault.empty()) {
        print_error(
            fmt::format("camopt: the NC program is refused and was not written: {}\n", exported.fault));
        return failure;
    }
    return exit_code_of(solution.certificate.verdict);
}

}  // namespace camopt::apps
