// SPDX-License-Identifier: MIT
// The example of paper 001 as a job: dx = dz = 0, dy = 150, f_l = 70, roller 8 x 20 mm, t = 120. All of these
// numbers are chosen, the paper gives none.
#pragma once

#include "profiles/spatial/reference_cams.hpp"
#include "shop/nc/block_angles.hpp"
#include "shop/nc/machine.hpp"
#include "shop/nc/nc_check.hpp"
#include "shop/nc/nc_program.hpp"
#include "shop/nc/nc_reader.hpp"
#include "shop/spatial/cam_export.hpp"

#include <numbers>
#include <utility>
#include <vector>

namespace camopt {

/// The cutter over the cam angle. Throws InputError for a location that is not valid.
[[nodiscard]] inline ToolPath cutter_path(RollerPath roller, const CutterLocation& location) {
    location.validate();
    return [roller = std::move(roller), location](double theta) {
        return cutter_pose(roller(theta, location.station), location);
    };
}

[[nodiscard]] inline ToolPath plane_cutter_path(PlaneContour contour, const PlaneCutter& cutter) {
    cutter.validate();
    return [contour = std::move(contour), cutter](double theta) {
        const ContourPoint point = contour(theta);
        const Eigen::Vector2d axis = point.position + (0.5 * cutter.diameter + cutter.stock) * point.normal;
        return ToolPose{{axis.x(), axis.y(), cutter.bottom}, -Eigen::Vector3d::UnitZ()};
    };
}

/// Moves from the block on in which every axis has a value.
[[nodiscard]] inline std::vector<NcMove> read_nc_text(std::string_view text, const Machine& machine,
                                                      const PostProcessor& post) {
    std::vector<NcMove> moves = read_nc_travel(text, machine, post);
    std::erase_if(moves, [](const NcMove& move) { return !move.values.allFinite(); });
    return moves;
}

}  // namespace camopt

namespace camopt::test {

inline constexpr double z_offset = 120.0 * millimetre;

inline RollerPath rotating_roller() {
    return roller_path(rotating_cam(), rotating_motion());
}

/// Cutter of this diameter at the roller's far end, h = 20 mm.
inline CutterLocation rotating_location(double diameter, double stock = 0.0, int flank = 1) {
    CutterLocation location;
    location.roller_radius = 8.0 * millimetre;
    location.diameter = diameter;
    location.stock = stock;
    location.flank = flank;
    location.station = 20.0 * millimetre;
    return location;
}

inline std::vector<ToolPose> poses_at(const ToolPath& path, const std::vector<double>& angles) {
    std::vector<ToolPose> poses;
    for (const double theta : angles) poses.push_back(path(theta));
    return poses;
}

inline std::vector<double> even(double begin, double end, int count) {
    std::vector<double> angles;
    for (int i = 0; i <= count; ++i) angles.push_back(begin + (end - begin) * i / count);
    return angles;
}

inline NcJob job_of(std::vector<ToolPose> poses) {
    NcJob job;
    job.title = "sample";
    job.tool = "end mill";
    job.blank = {100.0 * millimetre, -60.0 * millimetre, 60.0 * millimetre};
    job.passes.push_back({"groove", std::move(poses)});
    return job;
}

/// A program printed with so many decimals that rounding is far below what is looked for.
inline PostProcessor fine_post(const Machine& machine) {
    PostProcessor post = generic_post(machine);
    post.linear_decimals = post.angle_decimals = 9;
    return post;
}

}  // namespace camopt::test
