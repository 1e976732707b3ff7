// SPDX-License-Identifier: MIT
// camopt export: the cam of a scene, which is optimised, or of a result folder, which is used as it is:
// points, surfaces, drawings, solids, a picture, the NC program with its check. Of its motion, with or
// without a cam: a uniform table, electronic cams.
#include "apps/scene_loading.hpp"
#include "apps/shop/shop_commands.hpp"
#include "apps/terminal.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "report/cam/cam_files.hpp"
#include "report/csv/lobe_csv.hpp"
#include "report/csv/motion_csv.hpp"
#include "report/exports/workshop.hpp"
#include "report/folders/result_folder.hpp"
#include "report/solve/solution_document.hpp"
#include "shop/exports/workshop_files.hpp"
#include "shop/plc/plc_export.hpp"
#include "shop/plc/table_check.hpp"
#include "shop/sheet/sheet_files.hpp"
#include "studies/delivered/delivered_audit.hpp"

#include <fmt/format.h>

namespace camopt::apps {

namespace {

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
        if (kind.gives(CamOutput::sheet)) types.emplace_back(kind.type);
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
    const CamKind& kind = *cam_kind(cam->type);
    if (!request.sheet.empty() && !kind.gives(CamOutput::sheet)) refuse_drawing(request, cam->type);
    if (request.dxf && !kind.gives(CamOutput::outline))
        throw InputError(fmt::format("{}: --dxf: found with a cam of type \"{}\", which is not a plane curve",
                                     request.scene, cam->type));
    if ((request.step || request.stl || request.nc) && !kind.gives(CamOutput::solid))
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
ExportOptions options_of(const ExportRequest& request) {
    ExportOptions options;
    for (const auto& [key, value] : request.options)
        if (!value.empty()) options.settings.emplace_back(key, value);
    if (request.points) options.settings.emplace_back("points", fmt::to_string(*request.points));
    try {
        (void)workshop_options(options.settings);
    } catch (const InputError& error) {  // "cutter_mm: found …"
        const std::string_view words = error.what();
        const std::string_view key = words.substr(0, words.find(':'));
        throw InputError(flag_of(std::string(key)) + std::string(words.substr(key.size())));
    }
    return options;
}

/// Of the shop's files; electronic cams and programs are written with what was found of them.
bool is_wanted(const ExportRequest& request, std::string_view name) {
    if (name == drawn_profile || name == drawn_profile_check) return request.dxf;
    if (name.starts_with("drawing")) return !request.sheet.empty() && name.ends_with("." + request.sheet);
    if (name.ends_with(".step")) return request.step;
    if (name.ends_with(".stl")) return request.stl;
    if (name == "flanks.csv") return request.csv;
    return name == "cam.svg" && request.picture;
}

void export_cam(const ExportRequest& request, const ExportOptions& options, const Solution& solution,
                FolderUpdate& folder, Exported& result) {
    if (request.csv || request.picture)
        for (const CamFile& file : cam_files(solution, {.points = request.points}))
            if (file.view == CamView::table ? request.csv : file.view == CamView::picture && request.picture)
                folder.write(file.name, file.text);
    for (const ExportFile& file : workshop()->files(solution, options)) {
        if (!is_wanted(request, file.name)) continue;
        const MadeFile made = file.make();
        folder.write(file.name, made.bytes);
        result.text += made.words;
    }
    if (request.nc)
        for (const ExportedProgram& program : nc_programs(solution, workshop_options(options.settings)))
            write_program(program, folder, result);
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
    const ExportOptions options = options_of(request);
    prepare_folder(request.out);
    const InterruptWatch watch;  // until the files are written
    Solution solution = solved_or_read(request.scene, with_solver(request.settings, request.solver),
                                       [&](const Scene& scene) { check_wishes(request, scene); });
    // A prescribed motion that violates a limit is shown, not made.
    if (solution.certificate.verdict == Verdict::infeasible) withdraw_motion(solution);
    Exported exported;
    FolderUpdate folder(request.out);
    export_motion(request, solution, folder, exported);
    if (solution.cam) export_cam(request, options, solution, folder, exported);
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
