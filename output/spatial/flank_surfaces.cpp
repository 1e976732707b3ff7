// SPDX-License-Identifier: MIT
#include "output/spatial/flank_surfaces.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace camopt {

namespace {

constexpr double same_point = 1e-9;  // m

/// From the near end of flank `first` over the floor to the near end of the other one.
std::vector<Eigen::Vector3d> groove_section(const FlankGrid& grid, std::size_t angle, std::size_t first) {
    std::vector<Eigen::Vector3d> section;
    const std::size_t count = grid.heights.size();
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
                                gap / units::millimetre));
        }
}

void check_blank(const FlankGrid& grid, const GroovedBlank& blank) {
    if (!(blank.bore_radius > 0.0 && blank.outer_radius > blank.bore_radius && blank.upper > blank.lower))
        throw InputError("grooved cam: the blank needs 0 < bore radius < outer radius and lower < upper end");
    for (const FlankSurface& flank : grid.flanks)
        for (const Eigen::Vector3d& point : flank.points) {
            if (!(point.z() > blank.lower && point.z() < blank.upper))
                throw InputError(fmt::format("grooved cam: the groove reaches z = {:g} mm, beyond the blank",
                                             point.z() / units::millimetre));
            if (!(std::hypot(point.x(), point.y()) > blank.bore_radius))
                throw InputError("grooved cam: the groove reaches into the bore");
        }
}

}  // namespace

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
                const Eigen::Vector3d mm = flank.points[grid.index(i, j)] / units::millimetre;
                const Eigen::Vector3d& n = flank.normals[grid.index(i, j)];
                fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{}\n", flank.flank,
                               grid.heights[i] / units::millimetre, grid.angles[j] / units::degree, mm.x(),
                               mm.y(), mm.z(), n.x(), n.y(), n.z());
            }
    return text;
}

TriangleMesh groove_body(const FlankGrid& grid) {
    std::vector<std::vector<Eigen::Vector3d>> sections;
    for (std::size_t j = 0; j < grid.angles.size(); ++j) sections.push_back(groove_section(grid, j, 0));
    return swept_solid(sections, false);
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

}  // namespace camopt
