// SPDX-License-Identifier: MIT
// camopt export: optimise a scene with a barrel or cylindrical cam and write the cam: points, surfaces,
// solids, a picture, the NC program with its check.
#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/progress.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/disk/disk_export.hpp"
#include "output/report/folder_update.hpp"
#include "output/report/result_folder.hpp"
#include "output/spatial/cam_export.hpp"
#include "output/spatial/nc_export.hpp"
#include "output/surface/mesh_files.hpp"
#include "output/words/solution_text.hpp"
#include "profiles/spatial/spatial_mechanism.hpp"
#include "profiles/spatial/spatial_spec.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace camopt::apps {

namespace {

constexpr double whole_turn = 2.0 * std::numbers::pi;
constexpr double same_angle = 1e-9;  // rad

/// What was written, and what the check of a program found.
struct Exported {
    std::string text;
    std::vector<std::filesystem::path> written;
    std::string fault;  ///< why the program was not written; empty: it was, or none was asked for
};

Solution solved(const ExportRequest& request) {
    std::vector<std::string> settings = request.settings;
    if (!request.solver.empty()) settings.push_back("solver.name=\"" + request.solver + "\"");
    const Scene scene = load_scene(request.scene, settings);
    const bool spatial = scene.mechanism && is_spatial(*scene.mechanism);
    if (!scene.cam && !spatial)
        throw InputError(fmt::format("{}: export is for disk, barrel and cylindrical cams", request.scene));
    if (scene.cam && (request.csv || request.step || request.obj || request.picture))
        throw InputError(
            fmt::format("{}: of a disk cam export writes --stl and --nc; `camopt solve … --out DIR --dxf` "
                        "writes the rest",
                        request.scene));
    const SolveControl control{InterruptWatch::interrupted, terminal_progress()};
    Solution solution = solve(scene, control);
    end_progress();
    return solution;
}

std::string title_of(const Solution& solution) {
    return solution.scene.title.empty() ? "cam" : solution.scene.title;
}

PostProcessor post_of(const ExportRequest& request, const Machine& machine) {
    PostProcessor post = generic_post(machine);
    return request.post.empty() ? post : read_post(request.post, std::move(post));
}

void write_program(FolderUpdate& folder, const CheckedProgram& program, Exported& result) {
    result.text = nc_check_text(program);
    result.fault = program.fault();
    folder.remove_earlier("cam.nc");  // it does not go with this check
    if (result.fault.empty()) folder.write("cam.nc", program.program.text);
    folder.write("cam_nc_check.txt", result.text);
}

/// The same of all cams.
template <class Options>
void set_safety(const ExportRequest& request, Options& options) {
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
}

/// The delivered motion by the cam angle. What is left of the turn rests where the motion ends.
FollowerMotion follower_motion(const Solution& solution) {
    const auto motion = std::make_shared<const MotionChain>(*solution.motion);
    const MotionScale scale = motion_scale(solution.scene);
    FollowerMotion result;
    result.state = [motion, scale](double theta) -> FollowerState {
        const double x = theta / scale.unit_angle, end = motion->end();
        if (x >= end) return {state_of(motion->at(end, Side::left), scale).s, 0.0, 0.0};
        return state_of(motion->at(std::max(x, motion->begin())), scale);
    };
    for (const double x : motion->breakpoints()) result.breakpoints.push_back(scale.unit_angle * x);
    if (result.end() < whole_turn - same_angle) result.breakpoints.push_back(whole_turn);
    return result;
}

NcExportOptions nc_options(const ExportRequest& request) {
    NcExportOptions options;
    if (request.cutter_mm) options.cutter_diameter = *request.cutter_mm * units::millimetre;
    options.stock = request.stock_mm * units::millimetre;
    options.z_offset = request.z_offset_mm * units::millimetre;
    options.feed = request.feed_mm_min * units::millimetre / 60.0;
    options.rotary_speed = request.rotary_deg_s * units::degree;
    options.spindle_rpm = request.spindle_rpm;
    options.chord_tolerance = request.chord_mm * units::millimetre;
    set_safety(request, options);
    return options;
}

void export_spatial(const ExportRequest& request, const Solution& solution, FolderUpdate& folder,
                    Exported& result) {
    const SpatialCam cam =
        spatial_cam(spatial_follower(*solution.scene.mechanism), solution.scene.mechanism->rotation,
                    solution.mechanism->mechanism.dimensions);
    const FollowerMotion motion = follower_motion(solution);
    CamExportOptions options;
    options.csv = request.csv;
    options.stl = request.stl;
    options.obj = request.obj;
    options.step = request.step;
    options.picture = request.picture;
    options.sampling = {request.sections, request.points, 0.0, 0.0};
    options.title = title_of(solution);
    for (const std::filesystem::path& file : write_cam_files(folder.aside(), cam, motion, options))
        folder.add(file.filename().string());
    if (request.nc) {
        NcExportOptions nc = nc_options(request);
        nc.title = options.title;
        const auto machine = machine_for(cam, nc.z_offset);
        write_program(folder, nc_export(cam, motion, *machine, post_of(request, *machine), nc), result);
    }
}

void export_disk(const ExportRequest& request, const Solution& solution, FolderUpdate& folder,
                 Exported& result) {
    const MotionChain motion = cam_motion(solution);
    const ProfileShape shape = profile_shape(solution.cam->cam, motion, motion_scale(solution.scene));
    if (request.stl) {
        const DiskSolid solid{request.thickness_mm * units::millimetre,
                              0.5 * request.bore_mm * units::millimetre, request.points};
        folder.write("cam.stl", stl_bytes(disk_solid(shape, solid), title_of(solution)));
    }
    if (request.nc) {
        DiskNcOptions nc;
        if (request.cutter_mm) nc.cutter_diameter = *request.cutter_mm * units::millimetre;
        nc.stock = request.stock_mm * units::millimetre;
        nc.thickness = request.thickness_mm * units::millimetre;
        nc.feed = request.feed_mm_min * units::millimetre / 60.0;
        nc.spindle_rpm = request.spindle_rpm;
        nc.chord_tolerance = request.chord_mm * units::millimetre;
        nc.title = title_of(solution);
        set_safety(request, nc);
        const auto machine = plane_milling_machine();
        write_program(folder, disk_nc(shape, *machine, post_of(request, *machine), nc), result);
    }
}

}  // namespace

ExitCode export_command(const ExportRequest& request) {
    prepare_folder(request.out);
    const InterruptWatch watch;  // until the files are written
    const Solution solution = solved(request);
    Exported exported;
    FolderUpdate folder(request.out);
    if (solution.motion && solution.mechanism) export_spatial(request, solution, folder, exported);
    if (solution.motion && solution.cam) export_disk(request, solution, folder, exported);
    exported.written = folder.finish();
    print(summary_text(solution, exported.written) + exported.text);
    if (!exported.fault.empty()) {
        print_error(
            fmt::format("camopt: the NC program is refused and was not written: {}\n", exported.fault));
        return failure;
    }
    return exit_code_of(solution.certificate.verdict);
}

}  // namespace camopt::apps
