// SPDX-License-Identifier: MIT
// The reference numbers of the barrel cam (paper 002) and of the cylindrical cam with a rotating follower
// (paper 001), recomputed elsewhere in 60 digits from positions alone; to the digits they were given.
#include "benchmarks/papers/spatial_methods.hpp"
#include "reference_cams.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <vector>

namespace camopt {
namespace reference_test {

using namespace test;
using Eigen::Vector3d;

void expect_point(const Vector3d& found_m, const Vector3d& reference_mm, double tolerance_mm) {
    EXPECT_LT((found_m / millimetre - reference_mm).norm(), tolerance_mm) << found_m.transpose();
}

struct PressureReference {
    double height_mm, degrees, at_deg;
};

void expect_pressure(const SpatialCam& cam, const FollowerMotion& motion, const PressureReference& expected) {
    const SpatialExtreme found = largest_pressure_angle(cam, motion, expected.height_mm * millimetre);
    EXPECT_NEAR(found.value / degree, expected.degrees, 1e-10);
    EXPECT_NEAR(found.theta / degree, expected.at_deg, 1e-6);
}

struct UndercutReference {
    int flank;
    double least, at_deg, tolerance_deg;
};

void expect_undercut(const SpatialCam& cam, const FollowerMotion& motion, const UndercutReference& expected) {
    const SpatialExtreme found = least_undercut(cam, motion, expected.flank, {0.0, cam.roller_length});
    EXPECT_NEAR(found.value, expected.least, 1e-12);
    EXPECT_NEAR(found.theta / degree, expected.at_deg, expected.tolerance_deg);
    EXPECT_EQ(found.height, cam.roller_length);
}

TEST(BarrelCam, LargestPressureAngles) {
    for (const PressureReference& expected : {PressureReference{0.0, 38.0472102576, 248.708955},
                                              {19.05, 40.5556268302, 251.636047},
                                              {38.1, 43.7789637201, 254.863965}})
        expect_pressure(barrel_cam(), barrel_motion(), expected);
}

TEST(BarrelCam, LeastUndercutFunction) {
    expect_undercut(barrel_cam(), barrel_motion(), {1, 0.807743722215, 217.1292, 5e-5});
    expect_undercut(barrel_cam(), barrel_motion(), {-1, 0.687718113361, 333.2713, 5e-5});
}

TEST(BarrelCam, CriticalDimensions) {
    const auto radius = [](int flank) {
        return critical_roller_radius(barrel_cam(), barrel_motion(), {38.1 * millimetre, flank}).value();
    };
    const auto distance = [](int flank) {
        return critical_center_distance(barrel_cam(), barrel_motion(), {38.1 * millimetre, flank}).value();
    };
    EXPECT_NEAR(radius(1).value / millimetre, 160.5812769569, 1e-8);
    EXPECT_NEAR(radius(-1).value / millimetre, 95.0217882563, 1e-8);
    EXPECT_NEAR(distance(1).value / millimetre, 80.8364228355, 1e-8);
    EXPECT_NEAR(distance(-1).value / millimetre, 102.0995154388, 1e-8);
}

TEST(BarrelCam, PointsAt280Degrees) {
    const SpatialCam cam = barrel_cam();
    const double theta = 280.0 * degree;
    const FollowerState state = barrel_motion().state(theta);
    EXPECT_NEAR(state.s, 0.448798950512828, 1e-15);
    EXPECT_NEAR(state.velocity, 0.565586802627998, 1e-15);

    const SpatialPoint near = spatial_point(cam, theta, state, {0.0, -1});
    expect_point(near.contact, {-143.41135814182, 50.489344315146, 27.004045252152}, 1e-11);
    EXPECT_NEAR(std::tan(near.pressure_angle), 0.61837490420661, 1e-14);
    EXPECT_NEAR(near.undercut, 1.0148404164, 1e-10);

    const SpatialPoint tip = spatial_point(cam, theta, state, {38.1 * millimetre, 1});
    expect_point(tip.contact, {-112.30835034511, 7.4741115602681, -24.443988626445}, 1e-11);
    EXPECT_NEAR(std::tan(tip.pressure_angle), 0.82892078311878, 1e-14);
    EXPECT_NEAR(tip.undercut, 0.938036465281, 1e-12);
}

/// The paper's contact angle theta_r, counted in the index's frame against the index's turning.
double contact_angle(const SpatialCam& cam, double theta, const FollowerState& state,
                     const RollerStation& station) {
    const RollerAxis axis = roller_axis(cam, theta, state.s);
    const Vector3d normal = spatial_point(cam, theta, state, station).normal;
    // In the index's frame: outwards along the arm is b = u × e, across it u.
    const Vector3d outwards = -axis.travel.cross(axis.direction);
    return std::atan2(normal.dot(axis.travel), normal.dot(outwards));
}

TEST(BarrelCam, ContactAngleOfThePaper) {
    const SpatialCam cam = barrel_cam();
    const double theta = 280.0 * degree;
    const FollowerState state = barrel_motion().state(theta);
    EXPECT_NEAR(-contact_angle(cam, theta, state, {0.0, -1}), 1.0169753167658479, 1e-14);
    EXPECT_NEAR(-contact_angle(cam, theta, state, {38.1 * millimetre, 1}), -2.2629248173952397, 1e-14);
}

TEST(BarrelCam, RunsAtTheMachinesSpeed) {
    const double omega = 140.0 * full_turn / 60.0;
    EXPECT_NEAR(omega, 14.660765716752, 1e-12);
    double velocity = 0.0, acceleration = 0.0;
    for (int i = 0; i <= 16000; ++i) {
        const FollowerState state = barrel_motion().state((200.0 + 0.01 * i) * degree);
        velocity = std::max(velocity, std::abs(state.velocity));
        acceleration = std::max(acceleration, std::abs(state.acceleration));
    }
    EXPECT_NEAR(omega * velocity, 8.291935606, 1e-8);
    EXPECT_NEAR(omega * omega * acceleration, 136.761891, 1e-6);
}

TEST(RotatingFollower, LargestPressureAngles) {
    for (const PressureReference& expected : {PressureReference{0.0, 21.0523762235, 270.0},
                                              {10.0, 26.6906807469, 270.0},
                                              {20.0, 33.4188748499, 270.0}})
        expect_pressure(rotating_cam(), rotating_motion(), expected);
}

TEST(RotatingFollower, LeastUndercutFunctionAndCriticalRadius) {
    expect_undercut(rotating_cam(), rotating_motion(), {1, 0.884545469979, 201.989180, 2e-6});
    expect_undercut(rotating_cam(), rotating_motion(), {-1, 0.884545469979, 338.010819, 2e-6});
    for (const int flank : {1, -1})
        EXPECT_NEAR(
            critical_roller_radius(rotating_cam(), rotating_motion(), {20.0 * millimetre, flank})->value /
                millimetre,
            61.1559651020, 1e-8);
}

TEST(RotatingFollower, PointsAt240Degrees) {
    const SpatialCam cam = rotating_cam();
    const double theta = 240.0 * degree;
    const FollowerState state = rotating_motion().state(theta);
    EXPECT_NEAR(cam.start + state.s, -0.216636968809034, 1e-15);
    EXPECT_NEAR(state.velocity, 0.362712910853965, 1e-15);
    EXPECT_NEAR(state.acceleration, 0.282762813613391, 1e-14);
    // U and D are the paper's names.
    const SpatialPoint upper = spatial_point(cam, theta, state, {20.0 * millimetre, -1});
    const SpatialPoint lower = spatial_point(cam, theta, state, {20.0 * millimetre, 1});
    expect_point(upper.contact, {56.9626513392401, -28.5893499497106, -26.2609758448353}, 1e-12);
    expect_point(lower.contact, {50.6040677010072, -33.514324244021, -12.4293800469536}, 1e-12);
    EXPECT_NEAR(std::tan(lower.pressure_angle), 0.52563978541791, 1e-14);
    EXPECT_NEAR(lower.undercut, 0.9257573603125, 1e-13);
    EXPECT_NEAR(upper.undercut, 1.058605917656, 1e-12);
    const Vector3d orientation(-0.845782789417134, 0.488312921145936, -0.21494642162105);
    EXPECT_LT((roller_axis(cam, theta, state.s).direction - orientation).norm(), 1e-14);
}

/// g = 1 + σ r ρ s''/(ρ² + s'²)^1.5 − r² s'²/(ρ² + s'²)², tan φ = s'/ρ.
TEST(TranslatingFollower, HasTheShortFormulas) {
    const SpatialCam cam = translating_cam();
    const FollowerMotion motion = translating_motion();
    for (double theta = 101.0 * degree; theta < 250.0 * degree; theta += 3.0 * degree)
        for (const double height : {0.0, 0.5 * cam.roller_length, cam.roller_length})
            for (const int flank : {1, -1}) {
                const FollowerState state = motion.state(theta);
                const double rho = cam[SpatialDimension::center_distance] - height;
                const double squared = rho * rho + state.velocity * state.velocity;
                const double r = cam[SpatialDimension::roller_radius];
                const double g = 1.0 + flank * r * rho * state.acceleration / std::pow(squared, 1.5) -
                                 std::pow(r * state.velocity / squared, 2);
                const SpatialPoint point = spatial_point(cam, theta, state, {height, flank});
                EXPECT_NEAR(point.undercut, g, 1e-14);
                EXPECT_NEAR(std::tan(point.pressure_angle), state.velocity / rho, 1e-14);
            }
}

}  // namespace reference_test
}  // namespace camopt
