// SPDX-License-Identifier: MIT
#include "report/surface/triangle_mesh.hpp"

#include "core/errors.hpp"
#include "core/text/printable.hpp"
#include "core/units.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <iterator>

namespace camopt {

namespace {

// Diagonals closer than this, relative, are equally long: rounding shall not choose between the halves of a
// symmetric cell.
constexpr double same_length = 1e-6;

/// a b over c d as seen with the normal towards the viewer; the shorter diagonal splits it, of equal ones the
/// first.
void add_cell(TriangleMesh& mesh, std::array<int, 4> c) {
    const auto& p = mesh.vertices;
    const auto length = [&](int i, int k) { return (p[i] - p[k]).squaredNorm(); };
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
    for (int i = 0; i < corners; ++i) mean += mesh.vertices[first + i];
    const int middle = static_cast<int>(mesh.vertices.size());
    mesh.vertices.emplace_back(mean / corners);
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

constexpr std::size_t stl_header = 80, stl_triangle = 50;

void add_bytes(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((value >> shift) & 0xffU);
}

void add_vector(std::string& bytes, const Eigen::Vector3d& vector) {
    for (int i = 0; i < 3; ++i) add_bytes(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(vector(i))));
}

constexpr double margin = 12.0;   // px
constexpr double ambient = 0.38;  // share of the light that comes from everywhere
// Of the depth of the whole: facets less apart are equally far, and drawn in the order of their mesh. Which
// of them is nearer by rounding, or by the tolerance of the solve that made the surface, shall not decide how
// the picture is written.
constexpr double same_depth = 1e-6;

struct Facet {
    std::array<Eigen::Vector2d, 3> corner;
    int group = 0;  // before, of or after what is revolved
    double depth = 0.0;
    int shade = 0;  // 0 … 255 of the full light
    std::array<int, 3> colour{};
};

struct Camera {
    Eigen::Vector3d right, up, eye, light;

    explicit Camera(const MeshView& view)
        : eye(std::cos(view.elevation) * std::cos(view.azimuth),
              std::cos(view.elevation) * std::sin(view.azimuth), std::sin(view.elevation)) {
        right = view.up.cross(eye).normalized();
        up = eye.cross(right);
        light = (eye + 0.7 * up - 0.6 * right).normalized();
    }
};

void add_facets(std::vector<Facet>& facets, const PaintedMesh& part, const Camera& camera,
                bool has_revolved) {
    for (const auto& t : part.mesh.triangles) {
        std::array<Eigen::Vector3d, 3> p;
        for (std::size_t i = 0; i < 3; ++i) p[i] = part.mesh.vertices[t[i]];
        const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
        if (!(normal.dot(camera.eye) > 0.0)) continue;
        Facet facet;
        for (std::size_t i = 0; i < 3; ++i) facet.corner[i] = {p[i].dot(camera.right), -p[i].dot(camera.up)};
        facet.depth = (p[0] + p[1] + p[2]).dot(camera.eye);
        const Eigen::Vector3d middle = (p[0] + p[1] + p[2]) / 3.0;
        const bool towards = middle.x() * camera.eye.x() + middle.y() * camera.eye.y() > 0.0;
        facet.group = part.place == MeshPlace::revolved || !has_revolved     ? 1
                      : part.place == MeshPlace::around_revolved && !towards ? 0
                                                                             : 2;
        const double light = ambient + (1.0 - ambient) * std::max(0.0, normal.dot(camera.light));
        facet.shade = static_cast<int>(std::lround(255.0 * light));
        facet.colour = part.colour;
        facets.push_back(facet);
    }
}

void round_depths(std::vector<Facet>& facets) {
    double largest = 0.0;
    for (const Facet& facet : facets) largest = std::max(largest, std::abs(facet.depth));
    if (!(largest > 0.0)) return;
    for (Facet& facet : facets) facet.depth = std::round(facet.depth / (same_depth * largest));
}

std::vector<Facet> sorted_facets(std::span<const PaintedMesh> parts, const MeshView& view) {
    std::vector<Facet> facets;
    const Camera camera(view);
    const bool has_revolved =
        std::ranges::any_of(parts, [](const PaintedMesh& part) { return part.place == MeshPlace::revolved; });
    for (const PaintedMesh& part : parts) add_facets(facets, part, camera, has_revolved);
    if (facets.empty()) throw InputError("picture of a mesh: there is no facet to draw");
    round_depths(facets);
    std::ranges::stable_sort(facets, [](const Facet& a, const Facet& b) {
        return a.group != b.group ? a.group < b.group : a.depth < b.depth;
    });
    return facets;
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

double volume(const TriangleMesh& mesh) {
    double six_fold = 0.0;
    for (const auto& t : mesh.triangles) {
        const Eigen::Vector3d &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        six_fold += a.dot(b.cross(c));
    }
    return six_fold / 6.0;
}

std::string stl_bytes(const TriangleMesh& mesh, const std::string& title) {
    if (mesh.triangles.empty()) throw InputError("STL: the mesh has no triangles");
    std::string bytes = "binary STL in mm: " + printable(title);  // "solid" there would mean a text file
    bytes.resize(stl_header, ' ');
    bytes.reserve(stl_header + 4 + stl_triangle * mesh.triangles.size());
    add_bytes(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles) {
        std::array<Eigen::Vector3d, 3> corner;
        for (std::size_t i = 0; i < 3; ++i) corner[i] = mesh.vertices[triangle[i]] / units::millimetre;
        add_vector(bytes, (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized());
        for (const Eigen::Vector3d& point : corner) add_vector(bytes, point);
        bytes.append(2, '\0');
    }
    return bytes;
}

MeshElements mesh_elements(std::span<const PaintedMesh> parts, const MeshView& view, double height) {
    const std::vector<Facet> facets = sorted_facets(parts, view);
    Eigen::Vector2d low = facets[0].corner[0], high = low;
    for (const Facet& facet : facets)
        for (const Eigen::Vector2d& corner : facet.corner) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
    const Eigen::Vector2d size = (high - low).cwiseMax(Eigen::Vector2d::Constant(1e-12));
    MeshElements drawn;
    drawn.scale = std::min(view.width / size.x(), height / size.y());
    drawn.width = drawn.scale * size.x();
    drawn.height = drawn.scale * size.y();
    drawn.elements = "<g stroke-width=\".6\" stroke-linejoin=\"round\">\n";
    for (const Facet& facet : facets) {
        std::string path;
        for (const Eigen::Vector2d& corner : facet.corner) {
            const Eigen::Vector2d px = drawn.scale * (corner - low);
            fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', px.x(),
                           px.y());
        }
        const auto part = [&](std::size_t i) { return facet.colour[i] * facet.shade / 255; };
        const std::string colour = fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
        fmt::format_to(std::back_inserter(drawn.elements), "<path d=\"{}Z\" fill=\"{}\" stroke=\"{}\"/>\n",
                       path, colour, colour);
    }
    drawn.elements += "</g>\n";
    return drawn;
}

std::string mesh_svg(std::span<const PaintedMesh> parts, const MeshView& view, const std::string& title) {
    MeshView inside = view;
    inside.width = view.width - 2.0 * margin;
    const MeshElements drawn = mesh_elements(parts, inside, HUGE_VAL);
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" role=\"img\">\n<title>{2}</title>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<g transform=\"translate({3:.0f} {3:.0f})\">\n"
        "{4}</g>\n</svg>\n",
        view.width, drawn.height + 2.0 * margin, xml_text(title), margin, drawn.elements);
}

}  // namespace camopt
