// SPDX-License-Identifier: MIT
#include "output/surface/triangle_mesh.hpp"

#include "core/errors.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <map>
#include <utility>

namespace camopt {

namespace {

// Diagonals closer than this, relative, are equally long: rounding shall not choose between the halves of a
// symmetric cell.
constexpr double same_length = 1e-6;

/// a b over c d as seen with the normal towards the viewer; the shorter diagonal splits it, of equal ones the
/// first.
void add_cell(TriangleMesh& mesh, std::array<int, 4> c) {
    const auto& p = mesh.vertices;
    const auto length = [&](int i, int k) {
        return (p[static_cast<std::size_t>(i)] - p[static_cast<std::size_t>(k)]).squaredNorm();
    };
    if (length(c[0], c[2]) <= (1.0 + 2.0 * same_length) * length(c[1], c[3])) {
        mesh.triangles.push_back({c[0], c[1], c[2]});
        mesh.triangles.push_back({c[0], c[2], c[3]});
    } else {
        mesh.triangles.push_back({c[0], c[1], c[3]});
        mesh.triangles.push_back({c[1], c[2], c[3]});
    }
}

void add_cap(TriangleMesh& mesh, int first, int corners, bool turned) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (int i = 0; i < corners; ++i) mean += mesh.vertices[static_cast<std::size_t>(first + i)];
    const int middle = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(mean / corners);
    for (int i = 0; i < corners; ++i) {
        const int a = first + i, b = first + (i + 1) % corners;
        if (turned)
            mesh.triangles.push_back({middle, b, a});
        else
            mesh.triangles.push_back({middle, a, b});
    }
}

void check_sections(std::span<const std::vector<Eigen::Vector3d>> sections, bool ring) {
    const std::size_t least = ring ? 3 : 2;
    if (sections.size() < least)
        throw InputError(
            fmt::format("a swept solid needs {} sections at least, found {}", least, sections.size()));
    for (const auto& section : sections) {
        if (section.size() < 3 || section.size() != sections[0].size())
            throw InputError("the sections of a swept solid need the same number of corners, at least three");
        for (const Eigen::Vector3d& corner : section)
            if (!corner.allFinite()) throw InputError("a corner of a swept solid is not finite");
    }
}

}  // namespace

TriangleMesh mesh_of(const SurfaceGrid& grid) {
    grid.validate();
    TriangleMesh mesh;
    mesh.vertices = grid.points;
    const int columns = static_cast<int>(grid.u.size()), rows = static_cast<int>(grid.v.size());
    for (int row = 0; row + 1 < rows; ++row)
        for (int column = 0; column + 1 < columns; ++column) {
            const int corner = row * columns + column;
            add_cell(mesh, {corner, corner + 1, corner + columns + 1, corner + columns});
        }
    return mesh;
}

TriangleMesh swept_solid(std::span<const std::vector<Eigen::Vector3d>> sections, bool ring) {
    check_sections(sections, ring);
    TriangleMesh mesh;
    const int corners = static_cast<int>(sections[0].size()), count = static_cast<int>(sections.size());
    for (const auto& section : sections)
        mesh.vertices.insert(mesh.vertices.end(), section.begin(), section.end());
    for (int k = 0; k < (ring ? count : count - 1); ++k) {
        const int here = k * corners, next = (k + 1) % count * corners;
        for (int i = 0; i < corners; ++i) {
            const int after = (i + 1) % corners;
            add_cell(mesh, {here + i, here + after, next + after, next + i});
        }
    }
    if (!ring) {
        add_cap(mesh, 0, corners, true);
        add_cap(mesh, (count - 1) * corners, corners, false);
    }
    if (volume(mesh) < 0.0)
        for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& part) {
    const int offset = static_cast<int>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& t : part.triangles)
        mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

MeshEdges mesh_edges(const TriangleMesh& mesh) {
    std::map<std::pair<int, int>, std::pair<int, int>> passes;  // by edge: forward, backward
    MeshEdges edges;
    for (const auto& triangle : mesh.triangles) {
        if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
            ++edges.flat;
        for (std::size_t i = 0; i < 3; ++i) {
            const int a = triangle[i], b = triangle[(i + 1) % 3];
            auto& [forward, backward] = passes[std::minmax(a, b)];
            ++(a < b ? forward : backward);
        }
    }
    for (const auto& [edge, count] : passes) {
        const int total = count.first + count.second;
        if (total == 1) ++edges.open;
        if (total > 2) ++edges.crowded;
        if (total == 2 && count.first != 1) ++edges.reversed;
    }
    return edges;
}

double volume(const TriangleMesh& mesh) {
    double six_fold = 0.0;
    for (const auto& t : mesh.triangles) {
        const Eigen::Vector3d &a = mesh.vertices[static_cast<std::size_t>(t[0])],
                              &b = mesh.vertices[static_cast<std::size_t>(t[1])],
                              &c = mesh.vertices[static_cast<std::size_t>(t[2])];
        six_fold += a.dot(b.cross(c));
    }
    return six_fold / 6.0;
}

}  // namespace camopt
