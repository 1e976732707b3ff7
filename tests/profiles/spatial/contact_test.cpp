// SPDX-License-Identifier: MIT
// The flanks by envelope and by relative velocity, the pressure angle by its definition, contact lines,
// grids.
#include "benchmarks/papers/spatial_methods.hpp"
#include "core/errors.hpp"
#include "reference_cams.hpp"
#include "scene/cam_flanks.hpp"
#include "situations.hpp"
#include "tests/support/refusal.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace camopt {
namespace contact_test {

using testing_support::refusal;
using testing_support::says;

using namespace test;
using Eigen::Vector3d;

class ContactOf : public ::testing::TestWithParam<Case> {};

TEST_P(ContactOf, EnvelopeAndRelativeVelocityAgree) {
    repeat(GetParam(), [](const Situation& at) {
        const SpatialPoint point = spatial_point(at.cam, at.theta, at.state, at.station);
        const Vector3d envelope = envelope_contact(at.cam, at.theta, at.state, at.station);
        const Vector3d relative = relative_velocity_contact(at.cam, at.theta, at.state, at.station);
        EXPECT_LT((envelope - relative).norm(), 1e-15);  // 1e-12 mm
        EXPECT_LT((envelope - point.contact).norm(), 1e-15);
    });
}

/// cos φ = |n · v_f| / |v_f|, v_f the velocity of the axis as a point of the follower; at rest its direction.
TEST_P(ContactOf, PressureAngleUsesNormalAndTravel) {
    repeat(GetParam(), [](const Situation& at) {
        const SpatialPoint point = spatial_point(at.cam, at.theta, at.state, at.station);
        const RollerAxis axis = roller_axis(at.cam, at.theta, at.state.s);
        EXPECT_NEAR(std::cos(point.pressure_angle), std::abs(point.normal.dot(axis.travel)), 1e-14);
        EXPECT_NEAR(point.normal.dot(axis.direction), 0.0, 1e-15);
    });
}

TEST_P(ContactOf, LineContainsPointsOfAllHeights) {
    repeat(GetParam(), [](const Situation& at) {
        const std::vector<double> heights{0.0, 0.4 * at.cam.roller_length, at.cam.roller_length};
        const RollerAxis axis = roller_axis(at.cam, at.theta, at.state.s);
        for (const double height : heights) {
            const SpatialPoint point = spatial_point(at.cam, at.theta, at.state, {height, -1});
            const Vector3d from_foot = point.contact - axis.foot;
            EXPECT_NEAR(from_foot.dot(axis.direction), height, 1e-15);
            EXPECT_NEAR(from_foot.cross(axis.direction).norm(), at.cam[SpatialDimension::roller_radius],
                        1e-15);
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Spatial, ContactOf, ::testing::ValuesIn(every_case()), case_name);

TEST(FlankGrid, HasThePointsWhereItSays) {
    const SpatialCam cam = barrel_cam();
    const FollowerMotion motion = barrel_motion();
    const FlankGrid grid = flank_grid(cam, motion, FlankSampling{.sections = 8, .angles = 201});
    EXPECT_EQ(grid.heights.front(), 0.0);
    EXPECT_EQ(grid.heights.back(), cam.roller_length);
    EXPECT_EQ(grid.angles.front(), motion.begin());
    EXPECT_EQ(grid.angles.back(), motion.end());
    ASSERT_EQ(grid.breaks.size(), 3U);  // 200, 220 and 340 deg
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(grid.angles[static_cast<std::size_t>(grid.breaks[k])], motion.breakpoints[k + 1]);
    for (std::size_t j = 0; j < grid.angles.size(); j += 17)
        for (std::size_t i = 0; i < grid.heights.size(); ++i)
            for (const FlankSurface& flank : grid.flanks) {
                const std::size_t k = grid.index(i, j);
                const SpatialPoint point = spatial_point(cam, grid.angles[j], motion.state(grid.angles[j]),
                                                         {grid.heights[i], flank.flank});
                EXPECT_EQ(flank.points[k], point.contact);
                EXPECT_LT((grid.center(i, j) - grid.roller_radius * flank.normals[k] - point.contact).norm(),
                          1e-16);
            }
}

/// The paper's cloud has about 3200 points.
TEST(FlankGrid, OfThePapersSize) {
    const FlankGrid grid =
        flank_grid(barrel_cam(), barrel_motion(), FlankSampling{.sections = 8, .angles = 201});
    EXPECT_NEAR(static_cast<double>(2 * grid.flanks[0].points.size()), 3200.0, 64.0);
}

TEST(FlankGrid, RefusesWhatIsNoGrid) {
    EXPECT_EQ(refusal([&] { (void)flank_grid(barrel_cam(), barrel_motion(), FlankSampling{.sections = 1}); }),
              "sections: found 1; allowed: at least 2");
    EXPECT_EQ(refusal([&] { (void)flank_grid(barrel_cam(), barrel_motion(), FlankSampling{.angles = 1}); }),
              "angles: found 1; allowed: at least 2");
    EXPECT_EQ(refusal([&] {
                  (void)flank_grid(barrel_cam(), barrel_motion(),
                                   FlankSampling{.from_height = 0.02, .to_height = 0.01});
              }),
              "to_height: found 0.01 m; allowed: above from_height, 0.02 m");
}

TEST(SpatialFaults, NameWhatCannotBeBuilt) {
    const auto fault = [](SpatialCam cam, SpatialDimension dimension, double value) {
        cam[dimension] = value;
        return geometry_fault(cam, 0.0, full_turn / 7.0);
    };
    EXPECT_EQ(geometry_fault(barrel_cam(), 0.0, full_turn / 7.0), "");
    EXPECT_EQ(geometry_fault(rotating_cam(), 0.0, 45.0 * degree), "");
    EXPECT_EQ(geometry_fault(translating_cam(), 0.0, 0.04), "");
    EXPECT_TRUE(says(fault(barrel_cam(), SpatialDimension::roller_radius, 0.0), "roller_radius"));
    EXPECT_TRUE(says(fault(barrel_cam(), SpatialDimension::center_distance, 0.03), "far end"));
    EXPECT_TRUE(says(fault(rotating_cam(), SpatialDimension::center_distance, 0.08), "far end"));
    EXPECT_TRUE(says(geometry_fault(barrel_cam(), 0.0, 2.1), "right angle"));
    SpatialCam cam = translating_cam();
    cam.roller_length = 0.0;
    EXPECT_TRUE(says(geometry_fault(cam, 0.0, 0.01), "roller_length"));
}

/// The arm reaches farthest where it is straightest: at 0 where it passes that, else at the nearer end.
TEST(SpatialFaults, CheckFarEndAtStraightestArm) {
    const auto reaches = [](double low, double high, double center_distance) {
        SpatialCam cam = rotating_cam();
        cam.start = low;
        cam[SpatialDimension::center_distance] = center_distance;
        return geometry_fault(cam, 0.0, high - low).empty();
    };
    const SpatialCam cam = rotating_cam();
    const double longest = cam[SpatialDimension::arm_length] + cam.roller_length;
    for (const double sign : {1.0, -1.0}) {
        const double nearer = sign * 10.0 * degree, farther = sign * 50.0 * degree;
        const double low = std::min(nearer, farther), high = std::max(nearer, farther);
        EXPECT_TRUE(reaches(low, high, longest * std::cos(nearer) * (1.0 + 1e-9)));
        EXPECT_FALSE(reaches(low, high, longest * std::cos(nearer) * (1.0 - 1e-9)));
        // Straight at one end of the swing, and only just not.
        const double bent = sign * 5e-4;
        EXPECT_FALSE(reaches(std::min(0.0, farther), std::max(0.0, farther), longest * (1.0 - 1e-9)));
        EXPECT_TRUE(reaches(std::min(bent, farther), std::max(bent, farther),
                            longest * std::cos(bent) * (1.0 + 1e-9)));
        EXPECT_FALSE(reaches(-sign * 50.0 * degree < bent ? -50.0 * degree : bent,
                             -sign * 50.0 * degree < bent ? bent : 50.0 * degree, longest * (1.0 - 1e-9)));
    }
    EXPECT_TRUE(reaches(-20.0 * degree, 20.0 * degree, longest * (1.0 + 1e-9)));
    EXPECT_FALSE(reaches(-20.0 * degree, 20.0 * degree, longest * (1.0 - 1e-9)));
}

}  // namespace contact_test
}  // namespace camopt
