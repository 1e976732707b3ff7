// SPDX-License-Identifier: MIT
// A surface around the z axis, cut off by two planes across it and closed to a solid with a bore.
#pragma once

#include "output/surface/triangle_mesh.hpp"

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

}  // namespace camopt
