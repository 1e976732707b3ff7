// SPDX-License-Identifier: MIT
#include "output/spatial/cam_scene.hpp"

#include "core/units.hpp"
#include "core/whole_turn.hpp"
#include "output/spatial/cam_export.hpp"
#include "output/spatial/flank_surfaces.hpp"
#include "output/spatial/indexing_body.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace camopt {

namespace {

constexpr int scene_angles = 181, scene_heights = 3;
constexpr double closed_groove = 1e-9;  // of the lift: the follower is where it began
constexpr IndexingBodyOptions scene_body{120, 3};
// Choices of drawing: of the roller's radius beyond the groove, of the least radius of the flanks.
constexpr double beyond_groove = 1.0, bore_share = 0.35, core_share = 0.98;
constexpr int core_corners = 72;

struct Extent {
    double least_radius = HUGE_VAL, largest_radius = 0.0, lower = HUGE_VAL, upper = -HUGE_VAL;
};

void widen(Extent& extent, std::span<const Eigen::Vector3d> points) {
    for (const Eigen::Vector3d& point : points) {
        const double radius = std::hypot(point.x(), point.y());
        extent.least_radius = std::min(extent.least_radius, radius);
        extent.largest_radius = std::max(extent.largest_radius, radius);
        extent.lower = std::min(extent.lower, point.z());
        extent.upper = std::max(extent.upper, point.z());
    }
}

TriangleMesh tube(double inner, double outer, double lower, double upper) {
    std::vector<std::vector<Eigen::Vector3d>> sections;
    for (int k = 0; k < core_corners; ++k) {
        const double angle = units::turn * k / core_corners, c = std::cos(angle), s = std::sin(angle);
        const auto rim = [&](double radius, double z) { return Eigen::Vector3d(radius * c, radius * s, z); };
        sections.push_back({rim(inner, lower), rim(outer, lower), rim(outer, upper), rim(inner, upper)});
    }
    return swept_solid(sections, true);
}

std::vector<CamScene::Part> grooved_parts(const SpatialCam& cam, const FollowerMotion& motion) {
    const FlankGrid grid = flank_grid(cam, motion, {scene_heights, scene_angles, 0.0, 0.0});
    Extent extent;
    for (const FlankSurface& flank : grid.flanks) widen(extent, flank.points);
    const double margin = beyond_groove * cam[SpatialDimension::roller_radius];
    const double lower = extent.lower - margin, upper = extent.upper + margin;
    const double bore = bore_share * extent.least_radius;
    const double advance = motion.state(motion.end()).s - motion.state(motion.begin()).s;
    if (is_whole_turn(motion.end() - motion.begin()) && std::abs(advance) < closed_groove)
        return {{"drum", grooved_cam(grid, {bore, extent.largest_radius, lower, upper}), true}};
    std::vector<CamScene::Part> parts = {
        {"core", tube(bore, core_share * extent.least_radius, lower, upper), true}};
    for (const SurfaceGrid& flank : flank_surfaces(grid))
        parts.push_back({flank.name, mesh_of(flank), false});
    return parts;
}

std::optional<Eigen::Vector3d> pivot_of(const SpatialCam& cam) {
    const double across = cam[SpatialDimension::lateral_offset],
                 away = cam[SpatialDimension::center_distance];
    if (!swings(cam.follower)) return {};
    if (cam.follower == SpatialFollower::barrel) return Eigen::Vector3d(-across, away, -cam.axial_offset);
    return Eigen::Vector3d(across, away, cam.axial_offset);
}

}  // namespace

CamScene cam_scene(const SpatialCam& cam, const FollowerMotion& motion, std::span<const double> angles) {
    CamScene scene;
    scene.roller_radius = cam[SpatialDimension::roller_radius];
    scene.roller_length = cam.roller_length;
    scene.pivot = pivot_of(cam);
    double pitch = 0.0;
    int rollers = 1;
    if (indexes(cam, motion)) {
        pitch = motion.state(motion.end()).s - motion.state(motion.begin()).s;
        rollers = std::max(1, static_cast<int>(std::lround(units::turn / std::abs(pitch))));
        if (auto body = drawn_indexing_body(cam, motion, scene_body))
            scene.parts = {{"cam", std::move(*body), true}};
    }
    if (scene.parts.empty()) scene.parts = grooved_parts(cam, motion);
    for (int k = 0; k < rollers; ++k) {
        SpatialCam shifted = cam;
        shifted.start += k * pitch;
        std::vector<RollerPlace>& poses = scene.rollers.emplace_back();
        for (const double angle : angles) {
            // At cam angle 0 the cam frame is the one that stands still.
            const RollerAxis axis = roller_axis(shifted, 0.0, motion.state(angle).s);
            poses.push_back({axis.foot, axis.direction});
        }
    }
    return scene;
}

}  // namespace camopt
