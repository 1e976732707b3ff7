// SPDX-License-Identifier: MIT
#include "output/spatial/nc_export.hpp"

#include "core/units.hpp"
#include "output/nc/block_angles.hpp"
#include "output/spatial/roller_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace camopt {

namespace {

constexpr double equal_diameters = 1e-9;  // of the roller's
constexpr int checked_heights = 5;
constexpr int checked_angles = 360;
// Where the cutter has only begun, or has stopped, a flank is not finished: the roller's round end.
constexpr double end_share = 0.01;  // of the motion, left out at either end of an open path

std::vector<int> flanks_cut(const SpatialCam& cam, const NcExportOptions& options, double diameter) {
    const double roller = 2.0 * cam[SpatialDimension::roller_radius];
    const bool equal = options.stock == 0.0 && diameter >= roller * (1.0 - equal_diameters);
    return equal ? std::vector{1} : std::vector{1, -1};
}

std::vector<Eigen::Vector3d> flank_points(const RollerPath& roller, double radius, double height,
                                          const FollowerMotion& motion) {
    std::vector<Eigen::Vector3d> points;
    const double length = motion.end() - motion.begin();
    for (int k = 0; k <= checked_angles; ++k) {
        const double share = end_share + (1.0 - 2.0 * end_share) * k / checked_angles;
        const RollerPose at = roller(motion.begin() + share * length, height);
        for (const int flank : {1, -1}) points.push_back(at.center + flank * radius * at.normal);
    }
    return points;
}

std::string mm(double metres) {
    return fmt::format("{:.3g} mm", metres / units::millimetre);
}

}  // namespace

std::unique_ptr<Machine> machine_for(const SpatialCam& cam, double z_offset) {
    if (cam.follower == SpatialFollower::cylindrical_rotating) return table_tilting_machine(z_offset);
    return rotary_table_machine();
}

NcExport nc_export(const SpatialCam& cam, const FollowerMotion& motion, const Machine& machine,
                   const PostProcessor& post, const NcExportOptions& options) {
    const RollerPath roller = roller_path(cam, motion);
    CutterLocation location;
    location.roller_radius = cam[SpatialDimension::roller_radius];
    location.diameter = options.cutter_diameter.value_or(2.0 * location.roller_radius);
    location.stock = options.stock;
    location.station = cam.roller_length;
    location.tip_beyond = options.tip_beyond;
    const double working_length = cam.roller_length + options.tip_beyond;

    NcExport result;
    NcJob job;
    job.title = options.title;
    job.tool = fmt::format("cylindrical end mill, diameter {:g} mm, working length {:g} mm or more",
                           location.diameter / units::millimetre, working_length / units::millimetre);
    job.remarks = {"origin: the cam's centre; turn 0: the cam angle 0 of the motion"};
    job.feed = options.feed;
    job.rotary_speed = options.rotary_speed;
    job.spindle_rpm = options.spindle_rpm;
    std::vector<ToolPose> wanted;
    for (const int flank : flanks_cut(cam, options, location.diameter)) {
        location.flank = flank;
        const ToolPath path = cutter_path(roller, location);
        const BlockAngles blocks = block_angles(path, machine, motion.breakpoints,
                                                {options.blocks, options.chord_tolerance, working_length});
        result.chord_deviation = std::max(result.chord_deviation, blocks.chord_deviation);
        NcPass pass{fmt::format("flank {:+d}", flank), {}};
        for (const double theta : blocks.theta) pass.poses.push_back(path(theta));
        wanted.insert(wanted.end(), pass.poses.begin(), pass.poses.end());
        job.passes.push_back(std::move(pass));
    }
    if (job.passes.size() == 1) job.passes[0].name = "both flanks";
    result.program = nc_program(machine, post, job);

    const std::vector<NcMove> moves = read_nc_text(result.program.text, machine, post);
    result.poses = check_poses(moves, machine, post, wanted);
    for (int i = 0; i < checked_heights; ++i) {
        const double height = cam.roller_length * i / (checked_heights - 1);
        const NcSurfaceCheck check =
            check_surface(moves, machine, {location.diameter, working_length + location.diameter},
                          flank_points(roller, location.roller_radius, height, motion));
        result.surface.push_back({height, check.gouge, check.stock, check.least_stock});
    }
    return result;
}

std::string nc_check_text(const NcExport& result) {
    const NcPoseCheck& poses = result.poses;
    std::string text = fmt::format(
        "The printed program was read back and run through the machine's forward kinematics.\n"
        "  blocks             {}, {:.1f} s at the given feed\n"
        "  chord deviation    {} between blocks, before printing\n"
        "  tip at the blocks  {} off; the printed digits explain up to {}\n"
        "  axis at the blocks {:.2g} deg off; the printed digits explain up to {:.2g} deg\n"
        "  verdict            {}\n"
        "Flanks after machining, both, by the distance from the roller's near end:\n",
        poses.blocks, poses.cutting_seconds, mm(result.chord_deviation), mm(poses.tip_deviation),
        mm(poses.tip_rounding), poses.axis_deviation / units::degree, poses.axis_rounding / units::degree,
        poses.within_rounding ? "every block is where it belongs, within the printed digits"
                              : "WRONG: a block is farther off than the printed digits explain");
    for (const NcHeightCheck& height : result.surface)
        fmt::format_to(std::back_inserter(text), "  {:>8.3f} mm  stock left {} to {}, gouge {}\n",
                       height.height / units::millimetre, mm(height.least_stock), mm(height.most_stock),
                       mm(height.gouge));
    return text;
}

}  // namespace camopt
