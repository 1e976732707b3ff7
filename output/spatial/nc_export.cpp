// SPDX-License-Identifier: MIT
#include "output/spatial/nc_export.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/nc/milling/groove_passes.hpp"
#include "output/spatial/cam_export.hpp"
#include "output/spatial/indexing_body.hpp"
#include "output/spatial/roller_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

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

void widen(Blank& extent, const Eigen::Vector3d& point) {
    extent.radius = std::max(extent.radius, std::hypot(point.x(), point.y()));
    extent.lower = std::min(extent.lower, point.z());
    extent.upper = std::max(extent.upper, point.z());
}

Blank blank_of(const SpatialCam& cam, const FollowerMotion& motion, const BlankChoice& choice) {
    const RollerPath roller = roller_path(cam, motion);
    Blank extent{0.0, HUGE_VAL, -HUGE_VAL};
    double deepest = HUGE_VAL;  // radius
    for (int i = 0; i < checked_heights; ++i)
        for (const Eigen::Vector3d& point :
             flank_points(roller, cam[SpatialDimension::roller_radius],
                          cam.roller_length * i / (checked_heights - 1), motion)) {
            widen(extent, point);
            deepest = std::min(deepest, std::hypot(point.x(), point.y()));
        }
    if (indexes(cam, motion)) {
        const IndexingBody body = indexing_body(cam, motion);
        for (const TriangleMesh* part : {&body.thread, &body.hub})
            for (const Eigen::Vector3d& point : part->vertices) widen(extent, point);
    }
    extent.radius += choice.allowance;
    extent.lower -= choice.allowance;
    extent.upper += choice.allowance;
    const Blank blank = chosen_blank(extent, choice);
    if (blank.radius <= deepest)
        throw InputError(fmt::format("blank: {} ends above the groove, whose least radius is {:.3f} mm",
                                     words_of(blank), deepest / units::millimetre));
    return blank;
}

}  // namespace

std::unique_ptr<Machine> machine_for(const SpatialCam& cam, double z_offset) {
    if (cam.follower == SpatialFollower::cylindrical_rotating) return table_tilting_machine(z_offset);
    return rotary_table_machine();
}

NcWork nc_work(const SpatialCam& cam, const FollowerMotion& motion, const NcExportOptions& options) {
    const RollerPath roller = roller_path(cam, motion);
    CutterLocation location;
    location.roller_radius = cam[SpatialDimension::roller_radius];
    location.diameter = options.cutter_diameter.value_or(2.0 * location.roller_radius);
    location.stock = options.stock;
    location.station = cam.roller_length;
    location.tip_beyond = options.tip_beyond;
    const double working_length = cam.roller_length + options.tip_beyond;

    NcWork work;
    NcJob& job = work.job;
    job = milling_job(options, blank_of(cam, motion, options.blank), location.diameter, working_length);
    job.remarks = {"origin: the centre of the cam; turn 0: its cam angle 0"};
    job.rotary_speed = options.rotary_speed;

    CuttingTask& task = work.task;
    MillingPasses milled =
        groove_passes({roller, motion.breakpoints, location, flanks_cut(cam, options, location.diameter),
                       job.blank, options.milling});
    task.passes = std::move(milled.passes);
    job.remarks.insert(job.remarks.end(), milled.remarks.begin(), milled.remarks.end());
    task.knots = motion.breakpoints;
    task.blocks = {options.blocks, options.chord_tolerance, working_length};
    task.cutter = {location.diameter, working_length + location.diameter};
    GroovedBody body{roller, motion.begin(), motion.end(), location.roller_radius, working_length, job.blank};
    body.enough = 0.5 * (options.gouge_tolerance + options.chord_tolerance);
    task.finished = grooved_finished_cam(body);
    task.gouge_tolerance = options.gouge_tolerance;
    for (int i = 0; i < checked_heights; ++i) {
        const double height = cam.roller_length * i / (checked_heights - 1);
        task.surfaces.push_back({fmt::format("both flanks, {:.3f} mm from the near end of the roller",
                                             height / units::millimetre),
                                 flank_points(roller, location.roller_radius, height, motion)});
        if (i > 0 && i + 1 < checked_heights) continue;
        for (const std::size_t flank : {std::size_t{0}, std::size_t{1}}) {
            std::vector<Eigen::Vector3d>& line = task.outlines.emplace_back();
            for (std::size_t k = flank; k < task.surfaces.back().points.size(); k += 2)
                line.push_back(task.surfaces.back().points[k]);
        }
    }
    return work;
}

CheckedProgram nc_export(const SpatialCam& cam, const FollowerMotion& motion, const Machine& machine,
                         const PostProcessor& post, const NcExportOptions& options) {
    return checked_program(machine, post, nc_work(cam, motion, options));
}

}  // namespace camopt
