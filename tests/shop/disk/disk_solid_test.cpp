// SPDX-License-Identifier: MIT
// Disk cams as solids: volumes of circles with bore and keyway, which formulas know, and what is refused.
#include "shop/disk/disk_solid.hpp"

#include "core/errors.hpp"
#include "report/surface/mesh_cut.hpp"
#include "shop/disk/disk_export.hpp"
#include "tests/report/surface/mesh_edges.hpp"
#include "tests/shop/disk/harmonic_disk.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace camopt {
namespace disk_solid_test {

using testing_support::refusal;
using testing_support::says;

constexpr double turn = 2.0 * std::numbers::pi, millimetre = 1e-3;
constexpr double cubic_mm = millimetre * millimetre * millimetre;

ProfileShape shape_of(double lift, double end = turn) {
    ProfileShape shape = testing_support::harmonic_disk(lift, end);
    shape.knots = {0.0, 0.3 * end, end};
    return shape;
}

DrawingSpec drawn(double bore, bool keyway) {
    DrawingSpec drawing;
    if (bore > 0.0) drawing.bore = bore * millimetre;
    drawing.thickness = 12.0 * millimetre;
    if (keyway) drawing.keyway = Keyway{8.0 * millimetre, 3.3 * millimetre, 1.0};
    return drawing;
}

/// Of a disk of 40 mm, mm³: the slot is the rectangle above the chord across the bore, without the segment
/// there.
double expected_volume(double bore, bool keyway) {
    const double r = 0.5 * bore, half = 4.0, angle = std::asin(keyway ? half / r : 0.0);
    const double slot =
        2.0 * half * (r + 3.3 - r * std::cos(angle)) - r * r * (angle - std::sin(angle) * std::cos(angle));
    return 12.0 * (std::numbers::pi * (1600.0 - r * r) - (keyway ? slot : 0.0));
}

TEST(DiskSolid, BoreAndKeywayVolumesMatchFormula) {
    for (const auto& [bore, keyway] :
         {std::pair{0.0, false}, std::pair{25.0, false}, std::pair{25.0, true}}) {
        const double expected = expected_volume(bore, keyway) * cubic_mm;
        const DrawingSpec drawing = drawn(bore, keyway);
        EXPECT_NEAR(disk_volume(shape_of(0.0), drawing), expected, 1e-6 * expected);
        const DiskMesh solid = disk_mesh(shape_of(0.0), drawing);
        EXPECT_TRUE(mesh_edges(solid.mesh).watertight());
        EXPECT_NEAR(solid.exact, expected, 1e-6 * expected);
        EXPECT_LT(solid.volume, expected);  // chords of a convex outline
        // The rim gives at most its length times the deviation, the bore the same the other way.
        EXPECT_GT(solid.volume, expected - turn * 0.04 * 0.012 * solid.deviation);
        EXPECT_NEAR(volume(solid.mesh), solid.volume, 1e-15 * expected);
    }
}

TEST(DiskSolid, FinerFacetsConverge) {
    const ProfileShape shape = shape_of(10.0 * millimetre);
    double last = 1.0;
    for (const double tolerance : {1e-4, 1e-5, 1e-6}) {
        const DiskMesh solid = disk_mesh(shape, drawn(25.0, true), {tolerance});
        EXPECT_TRUE(mesh_edges(solid.mesh).watertight());
        const double error = std::abs(solid.volume / solid.exact - 1.0);
        EXPECT_LT(error, 0.3 * last);
        last = error;
    }
    const DiskMesh by_number = disk_mesh(shape, drawn(25.0, true), {5e-6, 100});
    EXPECT_TRUE(mesh_edges(by_number.mesh).watertight());
    const double sagitta = 0.05 * (1.0 - std::cos(turn / 200));
    EXPECT_NEAR(by_number.deviation, sagitta, 0.5 * sagitta);
}

// A dwell is an arc; every edge begins where the one before it ended.
TEST(DiskSolid, PlateOutlineHasTangentEdges) {
    ProfileShape shape = shape_of(10.0 * millimetre);
    const Plate plate = disk_plate(shape, drawn(25.0, true), "cam");
    ASSERT_EQ(plate.outline.size(), 2u);
    for (std::size_t i = 0; i < plate.outline.size(); ++i) {
        const PlateEdge& edge = plate.outline[i];
        EXPECT_EQ(edge.kind, PlateEdge::Kind::curve);
        EXPECT_EQ(edge.to, plate.outline[(i + 1) % plate.outline.size()].from);
        EXPECT_EQ(edge.poles.front(), edge.from);
        EXPECT_EQ(edge.poles.back(), edge.to);
        EXPECT_EQ(edge.knots.size(), edge.poles.size() + 4);
    }
    EXPECT_EQ(plate.hole.size(), 5u);
    for (std::size_t i = 0; i < plate.hole.size(); ++i)
        EXPECT_EQ(plate.hole[i].to, plate.hole[(i + 1) % plate.hole.size()].from);
    for (const PlateEdge& edge : disk_plate(shape_of(0.0), drawn(0.0, false), "disk").outline)
        EXPECT_EQ(edge.kind, PlateEdge::Kind::arc);
}

TEST(DiskSolid, RefusesWhatIsNoSolid) {
    ProfileShape open = shape_of(0.01, 2.0);
    open.open_because = "no return is given: motion.type is \"DRD\"";
    EXPECT_TRUE(says(refusal([&] { (void)disk_mesh(open, drawn(10.0, false)); }),
                     "found an open one (no return is given"));
    EXPECT_TRUE(says(refusal([&] { (void)disk_mesh(shape_of(0.0), drawn(80.0, false)); }),
                     "allowed: less than 40 mm"));
    EXPECT_TRUE(says(refusal([&] { (void)disk_mesh(shape_of(0.0), drawn(74.0, true)); }), "keyway"));
    DrawingSpec flat = drawn(10.0, false);
    flat.thickness = 0.0;
    EXPECT_THROW((void)disk_mesh(shape_of(0.0), flat), InputError);
    EXPECT_THROW((void)disk_mesh(shape_of(0.0), drawn(10.0, false), {0.0}), InputError);
    EXPECT_THROW((void)disk_mesh(shape_of(0.0), drawn(10.0, false), {5e-6, 3}), InputError);
    // A roller larger than the sharpest radius of its pitch curve.
    ProfileShape undercut = shape_of(0.0);
    undercut.at = [cam = undercut.cam](double theta) {
        const double lift = 8e-3, n = 8.0;
        return testing_support::point_at(cam, theta,
                                         {lift * (1.0 - std::cos(n * theta)), lift * n * std::sin(n * theta),
                                          lift * n * n * std::cos(n * theta)});
    };
    EXPECT_TRUE(says(refusal([&] { (void)disk_mesh(undercut, drawn(10.0, false)); }), "undercut"));
    EXPECT_TRUE(says(refusal([&] { (void)disk_nc_work(undercut, {}); }), "undercut"));
}

TEST(PlaneRegion, TrianglesCoverOutlineLessHole) {
    std::vector<Eigen::Vector2d> star, hole;
    for (int i = 0; i < 200; ++i) {
        const double angle = turn * i / 200, radius = 3.0 + std::cos(5.0 * angle);
        star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    for (const auto& corner : {std::pair{-0.5, -0.5}, {1.0, -0.5}, {1.0, 1.0}, {0.2, 0.1}})
        hole.emplace_back(corner.first, corner.second);
    for (const bool with_hole : {false, true}) {
        const std::vector<Eigen::Vector2d> inner = with_hole ? hole : std::vector<Eigen::Vector2d>{};
        std::vector<Eigen::Vector2d> points = star;
        points.insert(points.end(), inner.begin(), inner.end());
        double area = 0.0;
        const auto triangles = plane_triangles(star, inner);
        for (const auto& t : triangles) {
            const std::vector<Eigen::Vector2d> corners = {points[static_cast<std::size_t>(t[0])],
                                                          points[static_cast<std::size_t>(t[1])],
                                                          points[static_cast<std::size_t>(t[2])]};
            EXPECT_GT(polygon_area(corners), 0.0);
            area += polygon_area(corners);
        }
        EXPECT_EQ(triangles.size(), star.size() + inner.size() - 2 + (with_hole ? 2 : 0));
        EXPECT_NEAR(area, polygon_area(star) - (with_hole ? polygon_area(inner) : 0.0), 1e-12);
    }
    EXPECT_THROW((void)plane_triangles(std::vector<Eigen::Vector2d>{{0, 0}, {1, 1}, {1, 0}}, {}), InputError);
}

}  // namespace disk_solid_test
}  // namespace camopt
