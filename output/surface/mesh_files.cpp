// SPDX-License-Identifier: MIT
#include "output/surface/mesh_files.hpp"

#include "core/errors.hpp"
#include "core/text/printable.hpp"
#include "core/units.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>

namespace camopt {

namespace {

constexpr std::size_t stl_header = 80, stl_triangle = 50;

void add_bytes(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((value >> shift) & 0xffU);
}

void add_vector(std::string& bytes, const Eigen::Vector3d& vector) {
    for (int i = 0; i < 3; ++i) add_bytes(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(vector(i))));
}

}  // namespace

std::string stl_bytes(const TriangleMesh& mesh, const std::string& title) {
    if (mesh.triangles.empty()) throw InputError("STL: the mesh has no triangles");
    std::string bytes = "binary STL in mm: " + printable(title);  // "solid" there would mean a text file
    bytes.resize(stl_header, ' ');
    bytes.reserve(stl_header + 4 + stl_triangle * mesh.triangles.size());
    add_bytes(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles) {
        std::array<Eigen::Vector3d, 3> corner;
        for (std::size_t i = 0; i < 3; ++i)
            corner[i] = mesh.vertices[static_cast<std::size_t>(triangle[i])] / units::millimetre;
        add_vector(bytes, (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized());
        for (const Eigen::Vector3d& point : corner) add_vector(bytes, point);
        bytes.append(2, '\0');
    }
    return bytes;
}

std::string obj_text(std::span<const NamedMesh> meshes, const std::string& title) {
    std::string text = fmt::format("# {}\n# lengths in mm\n", printable(title));
    int offset = 1;
    for (const NamedMesh& part : meshes) {
        std::string name = part.name;
        std::replace(name.begin(), name.end(), ' ', '_');
        fmt::format_to(std::back_inserter(text), "o {}\n", name);
        for (const Eigen::Vector3d& vertex : part.mesh.vertices) {
            const Eigen::Vector3d mm = vertex / units::millimetre;
            fmt::format_to(std::back_inserter(text), "v {:.6f} {:.6f} {:.6f}\n", mm.x(), mm.y(), mm.z());
        }
        for (const auto& t : part.mesh.triangles)
            fmt::format_to(std::back_inserter(text), "f {} {} {}\n", t[0] + offset, t[1] + offset,
                           t[2] + offset);
        offset += static_cast<int>(part.mesh.vertices.size());
    }
    return text;
}

}  // namespace camopt
