// SPDX-License-Identifier: MIT
// B-spline surfaces through grids.
#include "report/surface/bspline_surface.hpp"

#include "core/errors.hpp"
#include "surface_samples.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace bspline_surface_test {

using testing_support::refusal;

using Surface = Eigen::Vector3d (*)(double u, double v);

SurfaceGrid grid_of(Surface surface, std::vector<double> u, std::vector<double> v) {
    SurfaceGrid grid{"sample", std::move(u), std::move(v), {}, {}};
    for (const double row : grid.v)
        for (const double column : grid.u) grid.points.push_back(surface(column, row));
    return grid;
}

Eigen::Vector3d bicubic(double u, double v) {
    return {u * u * u - 2.0 * v, u * v * v * v + 1.0, u * u * v + v * v};
}

Eigen::Vector3d smooth(double u, double v) {
    return {std::cos(u) * (2.0 + v), std::sin(u) * (2.0 + v), std::sin(2.0 * u + v)};
}

std::vector<double> even(double from, double to, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(from + (to - from) * i / (count - 1));
    return values;
}

TEST(BsplineSurface, ReproducesCubics) {
    const auto surfaces =
        bspline_surfaces(grid_of(bicubic, {0.0, 0.1, 0.3, 0.35, 0.7, 1.0}, {-1.0, 0.0, 0.2, 0.9, 1.0}));
    ASSERT_EQ(surfaces.size(), 1u);
    for (const double u : {0.0, 0.05, 0.32, 0.5, 0.99, 1.0})
        for (const double v : {-1.0, -0.4, 0.1, 0.95, 1.0})
            EXPECT_LT((surfaces[0].at(u, v) - bicubic(u, v)).norm(), 1e-14) << u << ' ' << v;
}

TEST(BsplineSurface, FewPointsCarryLowerDegrees) {
    const auto plane = [](double u, double v) { return Eigen::Vector3d(u, v, u + 2.0 * v); };
    const auto surfaces = bspline_surfaces(grid_of(plane, {0.0, 1.0, 4.0}, {0.0, 2.0}));
    EXPECT_EQ(surfaces[0].degree_u, 2);
    EXPECT_EQ(surfaces[0].degree_v, 1);
    EXPECT_LT((surfaces[0].at(2.5, 0.7) - plane(2.5, 0.7)).norm(), 1e-14);
}

TEST(BsplineSurface, ErrorOfFourthOrder) {
    double before = 0.0;
    for (const int count : {11, 21, 41}) {
        const auto surfaces = bspline_surfaces(grid_of(smooth, even(0.0, 3.0, count), even(0.0, 1.0, count)));
        double worst = 0.0;
        for (const double u : even(0.0, 3.0, 97))
            for (const double v : even(0.0, 1.0, 31))
                worst = std::max(worst, (surfaces[0].at(u, v) - smooth(u, v)).norm());
        if (before > 0.0) {
            EXPECT_GT(before / worst, 12.0) << count;
        }
        before = worst;
    }
}

TEST(BsplineSurface, BreaksMakePatches) {
    SurfaceGrid grid = grid_of(smooth, even(0.0, 3.0, 13), even(0.0, 1.0, 5));
    grid.breaks = {4, 6};
    const auto surfaces = bspline_surfaces(grid);
    ASSERT_EQ(surfaces.size(), 3u);
    EXPECT_EQ(surfaces[1].name, "sample piece 2");
    EXPECT_EQ(surfaces[1].knots_u.front(), grid.u[4]);
    EXPECT_EQ(surfaces[1].degree_u, 2);  // three columns
    for (const double v : even(0.0, 1.0, 9))
        EXPECT_LT((surfaces[0].at(grid.u[4], v) - surfaces[1].at(grid.u[4], v)).norm(), 1e-15);
    grid.breaks = {12};
    EXPECT_EQ(refusal([&] { (void)bspline_surfaces(grid); }),
              "surface sample: breaks must ascend between the first and the last column");
}

// The flanks of the reference cams between their points: patches at the jumps of the jerk.
TEST(BsplineSurface, FlanksBetweenTheirPoints) {
    const SpatialCam cam = test::barrel_cam();
    const FollowerMotion motion = test::barrel_motion();
    double before = 0.0;
    for (const int angles : {200, 400}) {
        double worst = 0.0;
        for (const SurfaceGrid& flank : flank_surfaces(test::barrel_grid(angles / 25, angles))) {
            const int side = flank.name == "flank +1" ? 1 : -1;
            for (const BsplineSurface& patch : bspline_surfaces(flank))
                for (const double u : even(patch.knots_u.front(), patch.knots_u.back(), 777))
                    for (const double v : {0.0, 0.011, 0.037}) {
                        const Eigen::Vector3d wanted =
                            spatial_point(cam, u, motion.state(u), {v, side}).contact;
                        worst = std::max(worst, (patch.at(u, v) - wanted).norm());
                    }
        }
        EXPECT_LT(worst / test::millimetre, angles == 200 ? 1e-4 : 1e-5) << angles;  // 7.5e-5, 4.4e-6
        if (before > 0.0) {
            EXPECT_GT(before / worst, 8.0);
        }
        before = worst;
    }
}

}  // namespace bspline_surface_test
}  // namespace camopt
