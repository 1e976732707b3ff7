// SPDX-License-Identifier: MIT
// The undercut function by its four definitions, and what it says: below the critical radius the flank's
// normal never flips and the cutter takes nothing away, above it both happen.
#include "benchmarks/papers/spatial_methods.hpp"
#include "core/errors.hpp"
#include "situations.hpp"
#include "tests/support/refusal.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <vector>

namespace camopt {
namespace spatial_undercut_test {

using testing_support::refusal;

using namespace test;
using Eigen::Vector3d;

/// Derivatives of order 1 and 2 by sixth-order central differences.
template <class Function>
auto slope(const Function& f, double step) {
    using Result = decltype(f(0.0));
    return Result(
        (45.0 * (f(step) - f(-step)) - 9.0 * (f(2 * step) - f(-2 * step)) + (f(3 * step) - f(-3 * step))) /
        (60.0 * step));
}
template <class Function>
auto bend(const Function& f, double step) {
    using Result = decltype(f(0.0));
    return Result((270.0 * (f(step) + f(-step)) - 27.0 * (f(2 * step) + f(-2 * step)) +
                   2.0 * (f(3 * step) + f(-3 * step)) - 490.0 * f(0.0)) /
                  (180.0 * step * step));
}

/// The situation carried on over the cam angle: s by its Taylor polynomial, so s''' = 0.
struct Moving {
    Situation at;
    [[nodiscard]] FollowerState state(double by) const {
        return {at.state.s + by * (at.state.velocity + 0.5 * by * at.state.acceleration),
                at.state.velocity + by * at.state.acceleration, at.state.acceleration};
    }
    [[nodiscard]] SpatialPoint point(double by, double higher = 0.0) const {
        return spatial_point(at.cam, at.theta + by, state(by),
                             {at.station.height + higher, at.station.flank});
    }
    /// Squared distance of a place from the roller's axis.
    [[nodiscard]] double squared_distance(const Vector3d& place, double by) const {
        const RollerAxis axis = roller_axis(at.cam, at.theta + by, state(by).s);
        return (place - axis.foot).cross(axis.direction).squaredNorm();
    }
};

constexpr double angle_step = 4e-3, height_step = 1e-3;

class UndercutOf : public ::testing::TestWithParam<Case> {};

/// (R_θ × R_h) · n / W, W = (V × e) · n σ_f.
double by_surface(const Moving& moving) {
    const int side = moving.at.station.flank;
    const Vector3d by_angle = slope([&](double by) { return moving.point(by).contact; }, angle_step);
    const Vector3d by_height = slope([&](double h) { return moving.point(0.0, h).contact; }, height_step);
    const Vector3d velocity = slope([&](double by) { return moving.point(by).center; }, angle_step);
    const Vector3d axis = roller_axis(moving.at.cam, moving.at.theta, moving.at.state.s).direction;
    const Vector3d normal = moving.point(0.0).normal;
    EXPECT_GT(side * velocity.cross(axis).dot(normal), 0.0);
    return side * by_angle.cross(by_height).dot(normal) / velocity.cross(axis).norm();
}

/// (d²/dθ'² dist²(R, axis(θ')))/(2W²).
double by_distance(const Moving& moving) {
    const Vector3d place = moving.point(0.0).contact;
    const Vector3d velocity = slope([&](double by) { return moving.point(by).center; }, angle_step);
    const Vector3d axis = roller_axis(moving.at.cam, moving.at.theta, moving.at.state.s).direction;
    return bend([&](double by) { return moving.squared_distance(place, by); }, angle_step) /
           (2.0 * velocity.cross(axis).squaredNorm());
}

/// (1 − r k1)(1 − r k2): the principal curvatures of the axis surface along n by its fundamental forms.
double by_curvatures(const Moving& moving) {
    const Vector3d by_angle = slope([&](double by) { return moving.point(by).center; }, angle_step);
    const Vector3d by_height = roller_axis(moving.at.cam, moving.at.theta, moving.at.state.s).direction;
    const Vector3d normal = moving.point(0.0).normal;
    Eigen::Matrix2d first, second;
    first << by_angle.dot(by_angle), by_angle.dot(by_height), by_angle.dot(by_height), 1.0;
    const double mixed =
        slope(
            [&](double by) {
                return roller_axis(moving.at.cam, moving.at.theta + by, moving.state(by).s).direction;
            },
            angle_step)
            .dot(normal);
    const Vector3d turning = bend([&](double by) { return moving.point(by).center; }, angle_step);
    second << turning.dot(normal), mixed, mixed, 0.0;
    const double r = moving.at.cam[SpatialDimension::roller_radius];
    return (Eigen::Matrix2d::Identity() - r * first.inverse() * second).determinant();
}

/// Litvin's limit function on the roller's surface (β about the axis, h along it): with the meshing function
/// f(β, h, θ) = N · S_θ in the roller's frame and the rates v_β, v_h of the surface's point along the two
/// coordinates, g = −r (f_θ − f_β v_β − f_h v_h) / f_β²; f_β = ±W.
double by_limit_function(const Moving& moving) {
    const Situation& at = moving.at;
    const auto frame = [&](double by) {
        const RollerAxis axis = roller_axis(at.cam, at.theta + by, moving.state(by).s);
        Eigen::Matrix3d columns;
        columns << axis.travel.cross(axis.direction), axis.travel, axis.direction;
        return columns;
    };
    const double r = at.cam[SpatialDimension::roller_radius];
    const auto on_roller = [&](double by, double beta, double h) {
        const RollerAxis axis = roller_axis(at.cam, at.theta + by, moving.state(by).s);
        const Vector3d own(r * std::cos(beta), r * std::sin(beta), at.station.height + h);
        return Vector3d(axis.foot + frame(by) * own);
    };
    const auto rate = [&](double by, double beta, double h) {
        return slope([&](double more) { return on_roller(by + more, beta, h); }, angle_step);
    };
    const auto meshing = [&](double by, double beta, double h) {
        return rate(by, beta, h).dot(frame(by) * Vector3d(std::cos(beta), std::sin(beta), 0.0));
    };
    const Vector3d own_normal = frame(0.0).transpose() * moving.point(0.0).normal;
    const double beta = std::atan2(own_normal.y(), own_normal.x());
    EXPECT_NEAR(meshing(0.0, beta, 0.0), 0.0, 1e-11);
    const double by_beta = slope([&](double more) { return meshing(0.0, beta + more, 0.0); }, angle_step);
    const double by_height = slope([&](double more) { return meshing(0.0, beta, more); }, height_step);
    const double by_theta = slope([&](double more) { return meshing(more, beta, 0.0); }, angle_step);
    const Vector3d velocity = rate(0.0, beta, 0.0);
    const Vector3d tangent = frame(0.0) * Vector3d(-std::sin(beta), std::cos(beta), 0.0);
    const double along_beta = velocity.dot(tangent) / r, along_axis = velocity.dot(frame(0.0).col(2));
    return -r * (by_theta - by_beta * along_beta - by_height * along_axis) / (by_beta * by_beta);
}

TEST_P(UndercutOf, FourDefinitionsAgree) {
    repeat(GetParam(), [](const Situation& at) {
        const Moving moving{at};
        const double g = moving.point(0.0).undercut;
        EXPECT_NEAR(by_curvatures(moving), g, 1e-8);
        EXPECT_NEAR(by_surface(moving), g, 1e-8);
        EXPECT_NEAR(by_distance(moving), g, 1e-8);
        EXPECT_NEAR(by_limit_function(moving), g, 1e-8);
    });
}

INSTANTIATE_TEST_SUITE_P(Spatial, UndercutOf, ::testing::ValuesIn(every_case()), case_name);

/// Cells of the grid in which σ_f (R_θ × R_h) · n, by differences of the points, has the wrong sign.
int folded_cells(const FlankGrid& grid, int flank) {
    const FlankSurface& surface = grid.flanks[flank > 0 ? 0 : 1];
    int folded = 0;
    for (std::size_t i = 0; i + 1 < grid.heights.size(); ++i)
        for (std::size_t j = 0; j + 1 < grid.angles.size(); ++j) {
            const Vector3d& corner = surface.points[grid.index(i, j)];
            const Vector3d by_angle = surface.points[grid.index(i, j + 1)] - corner;
            const Vector3d by_height = surface.points[grid.index(i + 1, j)] - corner;
            // The grid's normals point out of the material, n into it.
            const double side = -by_angle.cross(by_height).dot(surface.normals[grid.index(i, j)]);
            if (side * surface.flank < 0.0) ++folded;
        }
    return folded;
}

/// The flank at the roller's tip and the same cutter that makes it, both within 20 degrees of the place where
/// undercut begins: farther away a roller of the critical size meets other parts of the cam.
struct Tip {
    SpatialCam cam;
    FollowerMotion motion;
    int flank = 1;

    Tip(double share, int side) : cam(barrel_cam()), motion(barrel_motion()), flank(side) {
        const auto critical = critical_roller_radius(cam, motion, {cam.roller_length, flank}).value();
        cam[SpatialDimension::roller_radius] = share * critical.value;
        const double from = critical.theta - 20.0 * degree, to = critical.theta + 20.0 * degree;
        std::vector<double> places{from};
        for (const double place : motion.breakpoints)
            if (place > from && place < to) places.push_back(place);
        places.push_back(to);
        motion.breakpoints = places;
    }
    [[nodiscard]] FlankGrid grid(double below) const {
        std::vector<double> heights{cam.roller_length};
        if (below > 0.0) heights.insert(heights.begin(), cam.roller_length - below);
        FlankGrid both = flank_grid(cam, motion, heights, even_angles(motion, 1001));
        both.flanks[flank > 0 ? 1 : 0] = both.flanks[flank > 0 ? 0 : 1];
        return both;
    }
    [[nodiscard]] double depth() const { return interference(cam, motion, {}, grid(0.0)).depth; }
    [[nodiscard]] int folded() const { return folded_cells(grid(1e-7), flank); }
};

class CriticalRadius : public ::testing::TestWithParam<int> {};

TEST_P(CriticalRadius, BelowItNothingIsUndercut) {
    for (const double share : {0.5, 0.97, 0.999}) {
        const Tip tip(share, GetParam());
        EXPECT_LT(tip.depth(), 1e-16) << share;  // 1e-13 mm
        EXPECT_EQ(tip.folded(), 0) << share;
    }
}

TEST_P(CriticalRadius, AboveItBothAppear) {
    double before = 1e-8;
    for (const double share : {1.01, 1.05, 1.15}) {
        const Tip tip(share, GetParam());
        EXPECT_GT(tip.depth(), before) << share;
        EXPECT_GT(tip.folded(), 0) << share;
        before = tip.depth();
    }
}

INSTANTIATE_TEST_SUITE_P(Barrel, CriticalRadius, ::testing::Values(1, -1));

TEST(Interference, NoneInTheReferenceCams) {
    EXPECT_LT(interference(barrel_cam(), barrel_motion(), {}).depth, 1e-15);
    EXPECT_LT(interference(rotating_cam(), rotating_motion(), {}).depth, 1e-15);
    EXPECT_LT(interference(translating_cam(), translating_motion(), {}).depth, 1e-15);
}

/// g > 0 on the roller says nothing about a cutter that is longer: it sweeps where g < 0, and takes away from
/// the flank that the roller would have left alone.
TEST(Interference, CutterLongerThanRollerUndercutsFlank) {
    SpatialCam cam = barrel_cam();
    cam[SpatialDimension::roller_radius] = 0.97 * 95.0217882563 * millimetre;
    FollowerMotion motion = barrel_motion();
    motion.breakpoints = {300.0 * degree, 340.0 * degree, full_turn};
    const HeightRange roller{0.0, cam.roller_length}, cutter{0.0, 49.0 * millimetre};
    EXPECT_GT(least_undercut(cam, motion, -1, roller).value, 0.0);
    EXPECT_LT(least_undercut(cam, motion, -1, cutter).value, 0.0);
    EXPECT_LT(interference(cam, motion, {.cutter = roller, .sections = 3}).depth, 1e-15);
    const Interference found = interference(cam, motion, {.cutter = cutter, .sections = 3, .angles = 1441});
    EXPECT_GT(found.depth, 0.01 * millimetre);
    EXPECT_EQ(found.flank, -1);
}

/// A roller so large that the groove it makes in the dwell is met again on the way: g sees nothing of it.
TEST(Interference, SeesDistantPartsOfCam) {
    SpatialCam cam = barrel_cam();
    cam[SpatialDimension::roller_radius] = 80.0 * millimetre;
    for (const int flank : {1, -1})
        EXPECT_GT(least_undercut(cam, barrel_motion(), flank, {0.0, cam.roller_length}).value, 0.0);
    EXPECT_GT(interference(cam, barrel_motion(), {}).depth, 0.1 * millimetre);
}

TEST(Interference, RefusesOptionsThatCheckNothing) {
    EXPECT_EQ(refusal([&] { (void)interference(barrel_cam(), barrel_motion(), {.sections = 0}); }),
              "sections: found 0; allowed: at least 1");
    EXPECT_EQ(refusal([&] { (void)interference(barrel_cam(), barrel_motion(), {.angles = 1}); }),
              "angles: found 1; allowed: at least 2");
    EXPECT_EQ(refusal([&] {
                  (void)interference(barrel_cam(), barrel_motion(), {.cutter = {0.03, 0.02}});
              }),
              "a stretch from 0.03 to 0.02 m; allowed: to > from");
}

}  // namespace spatial_undercut_test
}  // namespace camopt
