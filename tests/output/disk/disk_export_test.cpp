// SPDX-License-Identifier: MIT
// Plane cams as programs and solids.
#include "output/disk/disk_export.hpp"

#include "core/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace camopt {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double millimetre = 1e-3;

/// A roller of 10 mm on a base circle of 40 mm, a harmonic of 10 mm; lift 0: a circle.
ProfileShape shape_of(double lift, double end = turn) {
    ProfileShape shape;
    shape.cam.dimensions[static_cast<std::size_t>(DimensionIndex::base_radius)] = 40.0 * millimetre;
    shape.cam.dimensions[static_cast<std::size_t>(DimensionIndex::roller_radius)] = 10.0 * millimetre;
    shape.at = [cam = shape.cam, lift](double theta) {
        const double half = 0.5 * lift;
        return profile_point(
            cam, theta, {half * (1.0 - std::cos(theta)), half * std::sin(theta), half * std::cos(theta)});
    };
    shape.knots = {0.0, end};
    shape.closed = end == turn;
    return shape;
}

TEST(DiskNc, IsCheckedAlongTheContour) {
    const auto machine = plane_milling_machine();
    DiskNcOptions options;
    options.chord_tolerance = 2e-6;
    for (const double stock : {0.0, 0.3 * millimetre}) {
        options.stock = stock;
        const CheckedProgram result =
            disk_nc(shape_of(10.0 * millimetre), *machine, generic_post(*machine), options);
        EXPECT_TRUE(result.poses.within_rounding);
        EXPECT_LE(result.chord_deviation, options.chord_tolerance);
        ASSERT_EQ(result.surfaces.size(), 1u);
        const double tolerance = options.chord_tolerance + result.poses.tip_rounding;
        EXPECT_NEAR(result.surfaces[0].check.least_stock, stock, tolerance);
        EXPECT_NEAR(result.surfaces[0].check.stock, stock, tolerance);
        EXPECT_NE(nc_check_text(result).find("the cam's contour"), std::string::npos);
    }
}

TEST(DiskSolid, IsWatertightWithTheVolumeOfARing) {
    const TriangleMesh ring = disk_solid(shape_of(0.0), {20.0 * millimetre, 5.0 * millimetre, 720});
    EXPECT_TRUE(mesh_edges(ring).watertight());
    const double polygon = 0.5 * 720 * std::sin(turn / 720);
    const double whole = polygon * (std::pow(40.0 * millimetre, 2) - std::pow(5.0 * millimetre, 2)) * 0.02;
    EXPECT_NEAR(volume(ring), whole, 1e-12 * whole);
    EXPECT_TRUE(mesh_edges(disk_solid(shape_of(10.0 * millimetre), {})).watertight());
}

TEST(DiskExport, RefusesWhatCannotBeMade) {
    const auto machine = plane_milling_machine();
    const PostProcessor post = generic_post(*machine);
    EXPECT_THROW(static_cast<void>(disk_nc(shape_of(0.01, 2.0), *machine, post, {})), InputError);
    EXPECT_THROW(static_cast<void>(disk_solid(shape_of(0.01, 2.0), {})), InputError);
    DiskNcOptions options;
    options.thickness = 0.0;
    EXPECT_THROW(static_cast<void>(disk_nc(shape_of(0.01), *machine, post, options)), InputError);
    EXPECT_THROW(static_cast<void>(disk_solid(shape_of(0.01), {0.02, 0.05, 720})), InputError);
    EXPECT_THROW(static_cast<void>(disk_solid(shape_of(0.01), {0.02, 0.0, 720})), InputError);
}

}  // namespace
}  // namespace camopt
