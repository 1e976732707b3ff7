// SPDX-License-Identifier: MIT
// The example of paper 001 as a job: dx = dz = 0, dy = 150, f_l = 70, roller 8 x 20 mm, t = 120. All of these
// numbers are chosen, the paper gives none.
#pragma once

#include "output/nc/block_angles.hpp"
#include "output/nc/machine.hpp"
#include "output/nc/nc_check.hpp"
#include "output/nc/nc_program.hpp"
#include "output/spatial/cam_export.hpp"
#include "profiles/spatial/reference_cams.hpp"

#include <numbers>
#include <vector>

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
