// SPDX-License-Identifier: MIT
// Meshes: what watertight means, and the files made from them.
#include "core/errors.hpp"
#include "report/surface/triangle_mesh.hpp"
#include "tests/report/surface/mesh_edges.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace camopt {
namespace mesh_test {

using testing_support::refusal;

using Section = std::vector<Eigen::Vector3d>;

/// A square outline of half-width a at height z.
Section square(double a, double z) {
    return {{-a, -a, z}, {a, -a, z}, {a, a, z}, {-a, a, z}};
}

TEST(SweptSolid, BoxInEitherDirection) {
    for (const double direction : {1.0, -1.0}) {
        const TriangleMesh box = swept_solid(
            std::vector{square(0.5, 0.0), square(0.5, direction), square(0.5, 2.0 * direction)}, false);
        EXPECT_TRUE(mesh_edges(box).watertight());
        EXPECT_NEAR(volume(box), 2.0, 1e-14);
    }
}

TEST(SweptSolid, Ring) {
    std::vector<Section> sections;
    const int count = 400;
    for (int k = 0; k < count; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / count, c = std::cos(angle), s = std::sin(angle);
        sections.push_back({{2 * c, 2 * s, 0}, {3 * c, 3 * s, 0}, {3 * c, 3 * s, 1}, {2 * c, 2 * s, 1}});
    }
    const TriangleMesh ring = swept_solid(sections, true);
    EXPECT_TRUE(mesh_edges(ring).watertight());
    const double polygon = 0.5 * count * std::sin(2.0 * std::numbers::pi / count);
    EXPECT_NEAR(volume(ring), 5.0 * polygon, 1e-12);
}

TEST(SweptSolid, RefusesWhatDoesNotMatch) {
    EXPECT_EQ(refusal([&] { (void)swept_solid(std::vector<Section>{square(1, 0)}, false); }),
              "a swept solid needs 2 sections at least, found 1");
    EXPECT_EQ(refusal([&] {
                  (void)swept_solid(std::vector{square(1, 0), square(1, 1)}, true);
              }),
              "a swept solid needs 3 sections at least, found 2");
    Section three = square(1, 1);
    three.pop_back();
    EXPECT_EQ(refusal([&] {
                  (void)swept_solid(std::vector{square(1, 0), three}, false);
              }),
              "the sections of a swept solid need the same number of corners, at least three");
    EXPECT_EQ(refusal([&] {
                  (void)swept_solid(std::vector{square(1, 0), square(NAN, 1)}, false);
              }),
              "a corner of a swept solid is not finite");
}

TEST(MeshEdges, EveryFaultIsFound) {
    const TriangleMesh box = swept_solid(std::vector{square(1, 0), square(1, 1)}, false);
    ASSERT_TRUE(mesh_edges(box).watertight());
    TriangleMesh open = box;
    open.triangles.pop_back();
    EXPECT_EQ(mesh_edges(open).open, 3);
    TriangleMesh turned = box;
    std::swap(turned.triangles[0][0], turned.triangles[0][1]);
    EXPECT_EQ(mesh_edges(turned).reversed, 3);
    TriangleMesh twice = box;
    twice.triangles.push_back(twice.triangles[0]);
    EXPECT_EQ(mesh_edges(twice).crowded, 3);
    TriangleMesh flat = box;
    flat.triangles[0][0] = flat.triangles[0][1];
    EXPECT_EQ(mesh_edges(flat).flat, 1);
}

TEST(MeshFiles, BinaryStl) {
    const TriangleMesh box = swept_solid(std::vector{square(0.01, 0), square(0.01, 0.02)}, false);
    const std::string bytes = stl_bytes(box, "box");
    ASSERT_EQ(bytes.size(), 84 + 50 * box.triangles.size());
    EXPECT_EQ(bytes.substr(0, 23), "binary STL in mm: box  ");
    const auto number = [&](std::size_t place) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[place + i])) << (8 * i);
        return value;
    };
    EXPECT_EQ(number(80), box.triangles.size());
    for (std::size_t i = 0; i < 3; ++i) {
        const auto corner = static_cast<std::size_t>(box.triangles[0][i]);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(std::bit_cast<float>(number(84 + 12 + 12 * i + 4 * k)),
                      static_cast<float>(1e3 * box.vertices[corner](static_cast<int>(k))));
    }
    EXPECT_EQ(refusal([&] { (void)stl_bytes({}, "nothing"); }), "STL: the mesh has no triangles");
}

TEST(MeshSvg, OutputIsIndependentOfRounding) {
    std::vector<Section> sections;
    for (int k = 0; k < 24; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 24, c = std::cos(angle), s = std::sin(angle);
        sections.push_back({{2 * c, 2 * s, 0}, {3 * c, 3 * s, 0}, {3 * c, 3 * s, 1}, {2 * c, 2 * s, 1}});
    }
    const auto picture = [&](double noise) {
        unsigned state = 1;
        for (Section& section : sections)
            for (Eigen::Vector3d& corner : section)
                for (double& x : corner)
                    x += noise * ((state = state * 1664525u + 1013904223u) / 4294967296.0 - 0.5);
        const PaintedMesh ring{swept_solid(sections, true), {200, 150, 100}};
        return mesh_svg(std::span(&ring, 1), {}, "ring");
    };
    const std::string exact = picture(0.0);
    EXPECT_EQ(picture(1e-12), exact);
    EXPECT_NE(picture(1e-1), exact);
}

TEST(MeshSvg, DrawsVisibleFacesBackToFront) {
    TriangleMesh two = swept_solid(std::vector{square(1, 0), square(1, 1)}, false);
    const PaintedMesh box{two, {200, 100, 50}};
    MeshView view;
    view.azimuth = view.elevation = 0.5;
    const std::string svg = mesh_svg(std::vector{box}, view, "a < b");
    std::size_t facets = 0;
    for (std::size_t place = 0; (place = svg.find("<path", place)) != std::string::npos; ++place) ++facets;
    EXPECT_EQ(facets, 8u);  // two sides of two triangles, a cap of four
    EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
    EXPECT_EQ(refusal([&] { (void)mesh_svg({}, view, ""); }), "picture of a mesh: there is no facet to draw");
}

}  // namespace mesh_test
}  // namespace camopt
