// SPDX-License-Identifier: MIT
// A shaded picture of solids: parallel projection, facets drawn from the farthest to the nearest (painter's
// algorithm, so facets that cut each other show it), those that look away left out.
#pragma once

#include "output/surface/triangle_mesh.hpp"

#include <array>
#include <span>
#include <string>

namespace camopt {

struct PaintedMesh {
    TriangleMesh mesh;
    std::array<int, 3> colour{};  ///< red, green, blue in full light, 0 … 255
};

struct MeshView {
    double azimuth = 0.6;                           ///< rad: the eye's direction, from x towards y
    double elevation = 0.4;                         ///< rad: above the x–y plane
    Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< drawn upwards
    double width = 900.0;                           ///< px
};

/// title: what a screen reader says. Throws InputError where there is nothing to draw.
[[nodiscard]] std::string mesh_svg(std::span<const PaintedMesh> parts, const MeshView& view,
                                   const std::string& title);

}  // namespace camopt
