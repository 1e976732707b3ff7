// SPDX-License-Identifier: MIT
// Whether a mesh is watertight, edge by edge.
#pragma once

#include "report/surface/triangle_mesh.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace camopt {

struct MeshEdges {
    int open = 0;      ///< edges of one triangle only
    int crowded = 0;   ///< edges of more than two
    int reversed = 0;  ///< edges that two triangles pass in the same direction
    int flat = 0;      ///< triangles that use a vertex twice

    [[nodiscard]] bool watertight() const { return open + crowded + reversed + flat == 0; }
};

[[nodiscard]] inline MeshEdges mesh_edges(const TriangleMesh& mesh) {
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

}  // namespace camopt
