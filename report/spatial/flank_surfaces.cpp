// SPDX-License-Identifier: MIT
#include "report/spatial/flank_surfaces.hpp"

#include "report/spatial/indexing_body.hpp"
#include "report/view/shown_units.hpp"

#include <fmt/format.h>

#include <iterator>

namespace camopt {

namespace {

constexpr double same_point = 1e-9;  // m

/// From the near end of flank `first` over the floor to the near end of the other one.
std::vector<Eigen::Vector3d> groove_section(const FlankGrid& grid, std::size_t angle, std::size_t first) {
    std::vector<Eigen::Vector3d> section;
    const std::size_t count = grid.heights.size();
    section.reserve(2 * count);
    for (std::size_t i = 0; i < count; ++i)
        section.push_back(grid.flanks[first].points[grid.index(i, angle)]);
    for (std::size_t i = count; i-- > 0;)
        section.push_back(grid.flanks[1 - first].points[grid.index(i, angle)]);
    return section;
}

void check_closed(const FlankGrid& grid) {
    for (const FlankSurface& flank : grid.flanks)
        for (std::size_t i = 0; i < grid.heights.size(); ++i) {
            const double gap =
                (flank.points[grid.index(i, 0)] - flank.points[grid.index(i, grid.angles.size() - 1)]).norm();
            if (!(gap <= same_point))
                throw InputError(
                    fmt::format("grooved cam: the groove does not close, its ends are {:g} mm apart",
                                millimetres_shown.of(gap)));
        }
}

void check_blank(const FlankGrid& grid, const GroovedBlank& blank) {
    if (!(blank.bore_radius > 0.0 && blank.outer_radius > blank.bore_radius && blank.upper > blank.lower))
        throw InputError("grooved cam: the blank needs 0 < bore radius < outer radius and lower < upper end");
    for (const FlankSurface& flank : grid.flanks)
        for (const Eigen::Vector3d& point : flank.points) {
            if (!(point.z() > blank.lower && point.z() < blank.upper))
                throw InputError(fmt::format("grooved cam: the groove reaches z = {:g} mm, beyond the blank",
                                             millimetres_shown.of(point.z())));
            if (!(std::hypot(point.x(), point.y()) > blank.bore_radius))
                throw InputError("grooved cam: the groove reaches into the bore");
        }
}

constexpr int scene_angles = 181, scene_heights = 3;
constexpr double closed_groove = 1e-9;  // of the lift: the follower is where it began
constexpr IndexingBodyOptions scene_body{120, 3};
// Choices of drawing: of the roller's radius beyond the groove, of the least radius of the flanks.
constexpr double beyond_groove = 1.0, bore_share = 0.35, core_share = 0.98;
constexpr int core_corners = 72, outside_halvings = 40;

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

struct Groove {
    FlankGrid grid;
    Extent extent;
    DrumSize body;
    double bore = 0.0;
};

Groove groove_of(const CamFlanks& cam, const FollowerMotion& motion, const FlankSampling& sampling) {
    Groove groove;
    groove.grid = flank_grid(cam, motion, sampling);
    Extent& extent = groove.extent;
    for (const FlankSurface& flank : groove.grid.flanks) widen(extent, flank.points);
    groove.body = body_around({extent.largest_radius, extent.lower, extent.upper}, cam.body,
                              beyond_groove * cam.roller_radius);
    groove.bore = cam.body.bore ? 0.5 * *cam.body.bore : bore_share * extent.least_radius;
    return groove;
}

std::vector<CamScene::Part> grooved_parts(const CamFlanks& cam, const FollowerMotion& motion) {
    const FlankSampling sampling{scene_heights, scene_angles, 0.0, 0.0};
    if (groove_closes(motion)) return {{"drum", drum_solid(cam, motion, sampling), true}};
    const Groove groove = groove_of(cam, motion, sampling);
    std::vector<CamScene::Part> parts = {
        {"core",
         tube(groove.bore, core_share * groove.extent.least_radius, groove.body.lower, groove.body.upper),
         true}};
    for (const SurfaceGrid& flank : flank_surfaces(groove.grid))
        parts.push_back({flank.name, mesh_of(flank), false});
    return parts;
}

}  // namespace

void cut_at_outside(FlankGrid& grid, const CamFlanks& cam, const FollowerMotion& motion, double radius) {
    for (std::size_t j = 0; j < grid.angles.size(); ++j)
        for (FlankSurface& flank : grid.flanks) {
            const FollowerState state = motion.state(grid.angles[j]);
            const auto at = [&](double height) {
                return cam.point(grid.angles[j], state, {height, flank.flank});
            };
            const auto inside = [&](double height) { return at(height).contact.head<2>().norm() <= radius; };
            const double top =
                inside(0.0) ? 0.0 : bisected(inside, {cam.roller_length, 0.0}, outside_halvings).with;
            for (std::size_t i = 0; i < grid.heights.size(); ++i) {
                const double share = grid.heights[i] / cam.roller_length;
                const FlankPoint point = at(top + share * (cam.roller_length - top));
                flank.points[grid.index(i, j)] = point.contact;
                flank.normals[grid.index(i, j)] = -point.normal;
            }
        }
}

std::array<SurfaceGrid, 2> flank_surfaces(const FlankGrid& grid) {
    std::array<SurfaceGrid, 2> surfaces;
    for (std::size_t side = 0; side < 2; ++side)
        surfaces[side] = {fmt::format("flank {:+d}", grid.flanks[side].flank), grid.angles, grid.heights,
                          grid.flanks[side].points, grid.breaks};
    return surfaces;
}

std::string flank_csv(const FlankGrid& grid) {
    std::string text = "flank,h_mm,theta_deg,x_mm,y_mm,z_mm,nx,ny,nz\n";
    for (const FlankSurface& flank : grid.flanks)
        for (std::size_t i = 0; i < grid.heights.size(); ++i)
            for (std::size_t j = 0; j < grid.angles.size(); ++j) {
                const Eigen::Vector3d mm = flank.points[grid.index(i, j)] / millimetres_shown.size;
                const Eigen::Vector3d& n = flank.normals[grid.index(i, j)];
                fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{}\n", flank.flank,
                               millimetres_shown.of(grid.heights[i]), degrees_shown.of(grid.angles[j]),
                               mm.x(), mm.y(), mm.z(), n.x(), n.y(), n.z());
            }
    return text;
}

TriangleMesh groove_body(const FlankGrid& grid) {
    std::vector<std::vector<Eigen::Vector3d>> sections(grid.angles.size());
    for (std::size_t j = 0; j < sections.size(); ++j) sections[j] = groove_section(grid, j, 0);
    return swept_solid(sections, false);
}

bool groove_closes(const FollowerMotion& motion) {
    const double advance = motion.state(motion.end()).s - motion.state(motion.begin()).s;
    return is_whole_turn(motion.end() - motion.begin()) && std::abs(advance) < closed_groove;
}

TriangleMesh drum_solid(const CamFlanks& cam, const FollowerMotion& motion, const FlankSampling& sampling) {
    Groove groove = groove_of(cam, motion, sampling);
    cut_at_outside(groove.grid, cam, motion, groove.body.radius);
    return grooved_cam(groove.grid, {groove.bore, groove.body.radius, groove.body.lower, groove.body.upper});
}

TriangleMesh grooved_cam(const FlankGrid& grid, const GroovedBlank& blank) {
    check_closed(grid);
    check_blank(grid, blank);
    const std::size_t near_lower = grid.flanks[0].points[0].z() < grid.flanks[1].points[0].z() ? 0 : 1;
    std::vector<std::vector<Eigen::Vector3d>> sections;
    for (std::size_t j = 0; j + 1 < grid.angles.size(); ++j) {
        const Eigen::Vector2d out = grid.feet[j].head<2>().normalized();
        const auto rim = [&](double radius, double z) {
            return Eigen::Vector3d(radius * out.x(), radius * out.y(), z);
        };
        std::vector<Eigen::Vector3d> section{rim(blank.bore_radius, blank.lower),
                                             rim(blank.outer_radius, blank.lower)};
        const auto groove = groove_section(grid, j, near_lower);
        section.insert(section.end(), groove.begin(), groove.end());
        section.push_back(rim(blank.outer_radius, blank.upper));
        section.push_back(rim(blank.bore_radius, blank.upper));
        sections.push_back(std::move(section));
    }
    return swept_solid(sections, true);
}

CamScene cam_scene(const CamFlanks& cam, const FollowerMotion& motion, std::span<const double> angles) {
    CamScene scene;
    scene.roller_radius = cam.roller_radius - 0.5 * cam.clearance;
    scene.roller_length = cam.roller_length;
    scene.pivot = cam.pivot;
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
        const double start = cam.start + k * pitch;
        std::vector<RollerPlace>& poses = scene.rollers.emplace_back();
        for (const double angle : angles) {
            // At cam angle 0 the cam frame is the one that stands still.
            const RollerAxis axis = cam.axis_at(0.0, start + motion.state(angle).s);
            poses.push_back({axis.foot, axis.direction});
        }
    }
    return scene;
}

}  // namespace camopt
