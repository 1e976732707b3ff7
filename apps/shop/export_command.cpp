// SPDX-License-Identifier: MIT
// camopt export: the cam of a scene, which is optimised, or of a result folder, which is used as it is:
// points, surfaces, drawings, solids, a picture, the NC program with its check. Of its motion, with or
// without a cam: a uniform table, electronic cams.
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "core/unit.hpp"
#include "output/csv/lobe_csv.hpp"
#include "output/csv/motion_csv.hpp"
#include "output/report/cam_files.hpp"
#include "output/report/result_folder.hpp"
#include "output/words/solution_text.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "shop/disk/disk_solid.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "apps/shop/shop_commands.hpp"
#include "shop/exports/workshop_files.hpp"
#include "shop/plc/plc_export.hpp"
#include "shop/plc/table_check.hpp"
#include "shop/sheet/sheet_files.hpp"
#include "shop/spatial/cam_export.hpp"
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

/// Of the command line; throws for an option that is not valid: before the work.
WorkshopOptions options_of(const ExportRequest& request) {
    std::vector<std::pair<std::string, std::string>> given;
    for (const auto& [key, value] : request.options)
        if (!value.empty()) given.emplace_back(key, value);
    try {
        return workshop_options(given);
    } catch (const InputError& error) {  // "cutter_mm: found …"
        const std::string_view words = error.what();
        const std::string_view key = words.substr(0, words.find(':'));
        throw InputError(flag_of(std::string(key)) + std::string(words.substr(key.size())));
    }
}

void export_programs(const ExportRequest& request, const WorkshopOptions& options, const Solution& solution,
                     FolderUpdate& folder, Exported& result) {
    if (!request.nc) return;
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
    return view == CamView::picture && request.picture;
}

/// What every plane cam has.
void export_plane(const ExportRequest& request, const WorkshopOptions& options, const Solution& solution,
                  FolderUpdate& folder) {
    if (request.csv || request.picture)
        for (const CamFile& file : cam_files(solution, {.points = request.points}))
            if (is_wanted(request, file.view)) folder.write(file.name, file.text);
    if (request.dxf)
        for (const FolderFile& file : dxf_files(solution, options.dxf_tolerance)) folder.write(file.name, file.text);
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
void export_piece(const ExportRequest& request, const WorkshopOptions& options, const Solution& solution,
                  const ProfileShape& shape, const std::string& name, FolderUpdate& folder,
                  Exported& result) {
    const DrawingSpec drawing = drawing_of(solution, shape, options.plate);
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

void export_disk(const ExportRequest& request, const WorkshopOptions& options, const Solution& solution,
                 FolderUpdate& folder, Exported& result) {
    const std::optional<ProfileShape> shape = delivered_shape(solution);
    if (!shape) return;
    const std::vector<ProfileShape> pieces = made_pieces(*shape);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        export_piece(request, options, solution, pieces[i], i == 0 ? first_piece : "cam_second", folder, result);
    if (!request.sheet.empty())
        for (const FolderFile& file : drawing_files(solution, request.sheet, options.plate))
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
        for (const FolderFile& file : exported.files) folder.write(file.name, file.text);
        result.text += exported.text;
    }
}

}  // namespace

std::vector<std::string> drawing_formats() {
    return {"svg", "pdf", "dxf"};
}

ExitCode export_command(const ExportRequest& request) {
    const WorkshopOptions options = options_of(request);
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
        export_plane(request, options, solution, folder);
        export_disk(request, options, solution, folder, exported);
        export_programs(request, options, solution, folder, exported);
    }
    exported.written = folder.finish();
    show_in(solution.scene, request.units);  // the files are written: for the words alone
    print(summary_text(solution, exported.written) + exported.text);
    if (!exported.fault.empty()) {
        print_error(
            fmt::format("camopt: the NC program is refused and was not written: {}\n", exported.fault));
        return failure;
    }
    return exit_code_of(solution.certificate.verdict);
}

}  // namespace camopt::apps
