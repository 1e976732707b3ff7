// SPDX-License-Identifier: MIT
// A surface around the z axis, cut off by two planes across it and closed to a solid with a bore.
#pragma once

#include "report/surface/triangle_mesh.hpp"

namespace camopt {

struct Bore {
    double lower = 0.0, upper = 0.0;  ///< z of the planes, m
    double radius = 0.0;              ///< m, > 0
    int corners = 96;                 ///< of its circle, >= 3
};

/// `surface`: seen from outside its triangles run counterclockwise or, all of them, clockwise; what is open
/// of it lies beyond the planes, and vertices nearer than 1e-8 m to each other are one. Throws
/// InputError where a plane's border does not go once around the bore.
[[nodiscard]] TriangleMesh bored_solid(const TriangleMesh& surface, const Bore& bore);

// A plane region between an outline and a hole as triangles on their corners: the caps of solids.
//
// The hole is joined to the outline by a bridge, then ears are cut off (G. H. Meisters, Polygons have ears,
// 1975). Takes time with the square of the corners: a tenth of a second for 3000.

/// Outline and hole turn to the left and cross neither themselves nor each other; the hole may be empty.
/// Indices count the outline's corners, then the hole's; the triangles turn to the left. Throws InputError
/// for fewer than three corners, for lines that turn to the right, and where crossing lines leave no ear to
/// cut.
[[nodiscard]] std::vector<std::array<int, 3>> plane_triangles(std::span<const Eigen::Vector2d> outline,
                                                              std::span<const Eigen::Vector2d> hole);

/// > 0 where it turns to the left.
[[nodiscard]] double polygon_area(std::span<const Eigen::Vector2d> polygon);

}  // namespace camopt
