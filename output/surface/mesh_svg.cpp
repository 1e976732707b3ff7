// SPDX-License-Identifier: MIT
#include "output/surface/mesh_svg.hpp"

#include "core/errors.hpp"
#include "core/text/printable.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace camopt {

namespace {

constexpr double margin = 12.0;   // px
constexpr double ambient = 0.38;  // share of the light that comes from everywhere

struct Facet {
    std::array<Eigen::Vector2d, 3> corner;
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

void add_facets(std::vector<Facet>& facets, const PaintedMesh& part, const Camera& camera) {
    for (const auto& t : part.mesh.triangles) {
        std::array<Eigen::Vector3d, 3> p;
        for (std::size_t i = 0; i < 3; ++i) p[i] = part.mesh.vertices[static_cast<std::size_t>(t[i])];
        const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
        if (!(normal.dot(camera.eye) > 0.0)) continue;
        Facet facet;
        for (std::size_t i = 0; i < 3; ++i) facet.corner[i] = {p[i].dot(camera.right), -p[i].dot(camera.up)};
        facet.depth = (p[0] + p[1] + p[2]).dot(camera.eye);
        const double light = ambient + (1.0 - ambient) * std::max(0.0, normal.dot(camera.light));
        facet.shade = static_cast<int>(std::lround(255.0 * light));
        facet.colour = part.colour;
        facets.push_back(facet);
    }
}

}  // namespace

std::string mesh_svg(std::span<const PaintedMesh> parts, const MeshView& view, const std::string& title) {
    std::vector<Facet> facets;
    const Camera camera(view);
    for (const PaintedMesh& part : parts) add_facets(facets, part, camera);
    if (facets.empty()) throw InputError("picture of a mesh: there is no facet to draw");
    std::ranges::stable_sort(facets, {}, &Facet::depth);
    Eigen::Vector2d low = facets[0].corner[0], high = low;
    for (const Facet& facet : facets)
        for (const Eigen::Vector2d& corner : facet.corner) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
    const double scale = (view.width - 2.0 * margin) / std::max((high - low).x(), 1e-12);
    const double height = scale * (high - low).y() + 2.0 * margin;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" width=\"{:.0f}\" "
        "height=\"{:.0f}\" role=\"img\">\n<title>{}</title>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<g stroke-width=\".6\" "
        "stroke-linejoin=\"round\">\n",
        view.width, height, view.width, height, xml_text(title));
    for (const Facet& facet : facets) {
        std::string path;
        for (const Eigen::Vector2d& corner : facet.corner) {
            const Eigen::Vector2d px = scale * (corner - low) + Eigen::Vector2d(margin, margin);
            fmt::format_to(std::back_inserter(path), "{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', px.x(),
                           px.y());
        }
        const auto part = [&](std::size_t i) { return facet.colour[i] * facet.shade / 255; };
        const std::string colour = fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
        fmt::format_to(std::back_inserter(svg), "<path d=\"{}Z\" fill=\"{}\" stroke=\"{}\"/>\n", path, colour,
                       colour);
    }
    return svg + "</g>\n</svg>\n";
}

}  // namespace camopt
