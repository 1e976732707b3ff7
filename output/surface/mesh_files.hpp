// SPDX-License-Identifier: MIT
// Meshes as files for printing, viewing and CAM: binary STL and OBJ, both in mm.
#pragma once

#include "output/surface/triangle_mesh.hpp"

#include <span>
#include <string>

namespace camopt {

/// Binary STL: an 80-byte header with `title`, then 50 bytes a triangle, little-endian single precision (a
/// vertex is within 1e-5 mm of itself below 170 mm). A mesh of no triangles is an InputError.
[[nodiscard]] std::string stl_bytes(const TriangleMesh& mesh, const std::string& title);

struct NamedMesh {
    std::string name;
    TriangleMesh mesh;
};
/// OBJ: one object a mesh, coordinates to the nanometre.
[[nodiscard]] std::string obj_text(std::span<const NamedMesh> meshes, const std::string& title);

}  // namespace camopt
