// SPDX-License-Identifier: MIT
// Triangles: open surfaces and closed solids, for STL, OBJ and pictures.
//
// In a solid the corners of a triangle run counterclockwise seen from outside, and every edge belongs to two
// triangles that pass it in opposite directions (watertight: mesh_edges). m.
#pragma once

#include "output/surface/bspline_surface.hpp"

#include <Eigen/Core>

#include <array>
#include <span>
#include <vector>

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

struct MeshEdges {
    int open = 0;      ///< edges of one triangle only
    int crowded = 0;   ///< edges of more than two
    int reversed = 0;  ///< edges that two triangles pass in the same direction
    int flat = 0;      ///< triangles that use a vertex twice

    [[nodiscard]] bool watertight() const { return open + crowded + reversed + flat == 0; }
};
[[nodiscard]] MeshEdges mesh_edges(const TriangleMesh& mesh);

/// Signed, m³: of a watertight mesh.
[[nodiscard]] double volume(const TriangleMesh& mesh);

}  // namespace camopt
