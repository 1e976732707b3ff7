// SPDX-License-Identifier: MIT
// Triangles: open surfaces and closed solids, for STL and pictures.
//
// In a solid the corners of a triangle run counterclockwise seen from outside, and every edge belongs to two
// triangles that pass it in opposite directions (watertight). m.
#pragma once

#include "report/surface/bspline_surface.hpp"

namespace camopt {

struct TriangleMesh {
    std::vector<Eigen::Vector3d> vertices;
    std::vector<std::array<int, 3>> triangles;  ///< indices of vertices
};

/// Two triangles a cell, split along the shorter diagonal. Its normals are ∂/∂u × ∂/∂v.
[[nodiscard]] TriangleMesh mesh_of(const SurfaceGrid& grid);

/// The solid that a closed outline sweeps from section to section; every section has as many corners, at
/// least three. `ring`: the last section is joined to the first; otherwise both ends are closed by fans from
/// their mean, which suits outlines that are seen whole from there. Turned so that its volume is > 0. Throws
/// InputError for fewer than two sections (ring: three) and sections that do not match.
[[nodiscard]] TriangleMesh swept_solid(std::span<const std::vector<Eigen::Vector3d>> sections, bool ring);

/// `part` beside what is there.
void append(TriangleMesh& mesh, const TriangleMesh& part);

/// Signed, m³: of a watertight mesh.
[[nodiscard]] double volume(const TriangleMesh& mesh);

/// Binary STL in mm, for printing, viewing and CAM: an 80-byte header with `title`, then 50 bytes a triangle,
/// little-endian single precision (a vertex is within 1e-5 mm of itself below 170 mm). A mesh of no triangles
/// is an InputError.
[[nodiscard]] std::string stl_bytes(const TriangleMesh& mesh, const std::string& title);

// A shaded picture of solids: parallel projection, facets drawn from the farthest to the nearest (painter's
// algorithm, so facets that cut each other show it), those that look away left out.
//
// What stands on a body of revolution about z is drawn before it where it stands on the far side, after it on
// the near side: a point outside of a cylinder whose radius looks away from the eye is never in front of it,
// and one whose radius looks towards the eye never behind. No order by depth could say so of large facets.
enum class MeshPlace {
    anywhere,         ///< by depth alone
    revolved,         ///< a body of revolution about z; anything else is drawn before or after all of it
    around_revolved,  ///< stands on such a body, outside of its radius
};

struct PaintedMesh {
    TriangleMesh mesh;
    std::array<int, 3> colour{};  ///< red, green, blue in full light, 0 … 255
    MeshPlace place = MeshPlace::anywhere;
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

/// The same as elements for a picture that has more to show.
struct MeshElements {
    std::string elements;              ///< SVG, in px from the upper left corner of the mesh's own box
    double width = 0.0, height = 0.0;  ///< px of that box
    double scale = 1.0;                ///< px per m across the line of sight
};
/// As large as fits into width × height px. Throws likewise.
[[nodiscard]] MeshElements mesh_elements(std::span<const PaintedMesh> parts, const MeshView& view,
                                         double height);

}  // namespace camopt
