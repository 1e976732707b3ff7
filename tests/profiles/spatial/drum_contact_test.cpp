// SPDX-License-Identifier: MIT
// Roller and groove of a drum, rebuilt from points alone: which flank pushes, the lever of the force along
// the normal, the curvature of the gap between roller and flank.
#include "profiles/spatial/spatial_cam.hpp"
#include "situations.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace camopt {
namespace drum_contact_test {

using namespace test;
using Eigen::Matrix2d, Eigen::Vector2d, Eigen::Vector3d;

/// The formulas of a situation's cam with this clearance.
std::shared_ptr<const CamMechanism> mechanism_of(const SpatialCam& cam) {
    CamSpec spec = spatial_spec(cam.follower);
    spec.rotation = cam.rotation;
    spec.dimensions.push_back({"groove_clearance", Dimension(cam.form.groove_clearance), false});
    return spatial_mechanism(spec);
}

std::vector<double> numbers_of(const SpatialCam& cam) {
    std::vector<double> numbers(cam.dimensions.begin(), cam.dimensions.end());
    for (const double number : {cam.axial_offset, cam.roller_length, cam.start}) numbers.push_back(number);
    return numbers;
}

RollerStation station_of(const SpatialCam& cam, int station) {
    const int height = station / 2;
    return {cam.roller_length * height / (mechanism_heights - 1), station % 2 == 0 ? 1 : -1};
}

class DrumContact : public ::testing::TestWithParam<Case> {};

TEST_P(DrumContact, SideZeroPushesTheFollowerOn) {
    repeat(GetParam(), [](const Situation& at) {
        const auto mechanism = mechanism_of(at.cam);
        const std::vector<double> numbers = numbers_of(at.cam);
        EXPECT_EQ(mechanism->sides(), 2);
        for (int station = 0; station < mechanism->stations(); ++station) {
            const MechanismPoint point = mechanism->point(at.theta, {numbers, at.state}, station);
            // The way of the roller's axis as the follower moves by +s, along the normal out of the cam.
            constexpr double step = 1e-6;
            const double height = station_of(at.cam, station).height;
            const auto center = [&](double by) -> Vector3d {
                const RollerAxis axis = roller_axis(at.cam, at.theta, at.state.s + by);
                return axis.foot + height * axis.direction;
            };
            const Vector3d way = (center(step) - center(-step)) / (2.0 * step);
            const double lever =
                mechanism->quantity(MechanismQuantity::normal_lever, {numbers, at.state}, station, {}).value;
            EXPECT_GT(lever, 0.0);
            EXPECT_NEAR(mechanism->pressing_sense(station) * lever, way.dot(point.normal), 1e-8 * way.norm());
            EXPECT_EQ(mechanism->side_name(mechanism->side_of(station)),
                      station % 2 == 0 ? "flank +" : "flank -");
        }
    });
}

/// The relative curvature of roller and flank across their line of contact, times the cosine of its
/// inclination: from the gap between the roller and points of the flank around the contact.
double inverse_contact_radius(const Situation& at, const RollerStation& station) {
    const SpatialPoint contact = spatial_point(at.cam, at.theta, at.state, station);
    RollerAxis axis = roller_axis(at.cam, at.theta, at.state.s);
    const double radius = at.cam[SpatialDimension::roller_radius];
    axis.foot += 0.5 * at.cam.form.groove_clearance * contact.normal;  // moved until it touches
    const auto flank = [&](double angle, double height) {
        FollowerState state = at.state;
        state.s += angle * at.state.velocity + 0.5 * angle * angle * at.state.acceleration;
        state.velocity += angle * at.state.acceleration;
        return spatial_point(at.cam, at.theta + angle, state, {station.height + height, station.flank})
            .contact;
    };
    const auto gap = [&](double angle, double height) {
        const Vector3d from = flank(angle, height) - axis.foot;
        return (from - from.dot(axis.direction) * axis.direction).norm() - radius;
    };
    constexpr double turn = 2e-4, along = 2e-5;
    const Vector3d by_turn = (flank(turn, 0.0) - flank(-turn, 0.0)) / (2.0 * turn);
    const Vector3d by_height = (flank(0.0, along) - flank(0.0, -along)) / (2.0 * along);
    Matrix2d metric, bend;
    metric << by_turn.dot(by_turn), by_turn.dot(by_height), by_turn.dot(by_height), by_height.dot(by_height);
    const double here = gap(0.0, 0.0);
    bend(0, 0) = (gap(turn, 0.0) - 2.0 * here + gap(-turn, 0.0)) / (turn * turn);
    bend(1, 1) = (gap(0.0, along) - 2.0 * here + gap(0.0, -along)) / (along * along);
    bend(0, 1) = bend(1, 0) =
        (gap(turn, along) - gap(turn, -along) - gap(-turn, along) + gap(-turn, -along)) /
        (4.0 * turn * along);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix2d> solver(bend, metric);
    const Vector2d line = solver.eigenvectors().col(0);  // of the least curvature: the line of contact
    const Vector3d direction = (line.x() * by_turn + line.y() * by_height).normalized();
    return solver.eigenvalues().maxCoeff() * std::abs(direction.dot(axis.direction));
}

TEST_P(DrumContact, RadiusIsThatOfTheGap) {
    for (const double clearance : {0.0, 1e-5})
        repeat(GetParam(), [clearance](Situation at) {
            at.cam.form.groove_clearance = clearance;
            const SpatialPoint point = spatial_point(at.cam, at.theta, at.state, at.station);
            if (!(point.undercut > 0.2)) return;
            EXPECT_NEAR(point.contact_radius * inverse_contact_radius(at, at.station), 1.0, 2e-3);
        });
}

TEST_P(DrumContact, FlanksLieHalfTheClearanceFurther) {
    repeat(GetParam(), [](Situation at) {
        const SpatialPoint tight = spatial_point(at.cam, at.theta, at.state, at.station);
        at.cam.form.groove_clearance = 2e-4;
        const SpatialPoint wide = spatial_point(at.cam, at.theta, at.state, at.station);
        EXPECT_LT((wide.contact - tight.contact - 1e-4 * tight.normal).norm(), 1e-12);
        EXPECT_EQ(wide.pressure_angle, tight.pressure_angle);
        EXPECT_NE(wide.undercut, tight.undercut);
    });
}

TEST_P(DrumContact, BodyHoldsTheWholeGroove) {
    repeat(GetParam(), [](const Situation& at) {
        const DrumExtent extent = drum_extent(at.cam, 0.0, at.state.s);
        for (const double height : {0.0, at.cam.roller_length})
            for (const int flank : {1, -1}) {
                // At rest a flank is as far along the axis as the roller's side.
                const SpatialPoint point =
                    spatial_point(at.cam, at.theta, {at.state.s, 0.0, 0.0}, {height, flank});
                EXPECT_GE(point.contact.z(), extent.lower - 1e-12);
                EXPECT_LE(point.contact.z(), extent.upper + 1e-12);
            }
        EXPECT_GT(extent.outer_radius, extent.floor_radius);
    });
}

INSTANTIATE_TEST_SUITE_P(Spatial, DrumContact, ::testing::ValuesIn(every_case()), case_name);

}  // namespace drum_contact_test
}  // namespace camopt
