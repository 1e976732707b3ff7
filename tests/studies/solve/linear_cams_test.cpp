// SPDX-License-Identifier: MIT
// Plates against references of an independent program (docs/linear_cams.md): optima, what is proved of
// ranges and of impossible scenes, forces along the travel.
#include "studies/check/check_cam.hpp"
#include "studies/check/forward_check_input.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/delivered/driven_mechanism.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace camopt {
namespace linear_cams_test {

using namespace testing_support;

/// A rise of 20 mm while the plate slides by `travel_mm`, in 24 cubic segments.
TestScene wedge(double travel_mm, double inclination_deg,
                const std::string& follower = "translating_roller") {
    const TestScene scene(R"(
[motion]
type = "DRD"
lift_mm = 20
rise_deg = 60
[spline]
degree = 3
segments = 24
[objective]
velocity = 0.4
acceleration = 0.4
jerk = 0.2
reference = { velocity = 1.76, acceleration = 5.53, jerk = 69 }
[cam]
type = "linear"
follower = "translating_knife"
travel_mm = 100
base_height_mm = 25
[limits]
pressure_angle_deg = 30
[solver]
tolerance = 1e-11
)");
    const TestScene own =
        scene.set("cam.travel_mm", 6.0 * travel_mm).set("cam.inclination_deg", inclination_deg);
    if (follower == "translating_knife") return own;
    return own.set("cam.follower", follower).with("cam.roller_radius_mm = 0.5");
}

struct Reference {
    double travel, inclination, objective, velocity;
};

class LinearOptima : public testing::TestWithParam<Reference> {};

TEST_P(LinearOptima, MatchIndependentProgram) {
    const Reference& known = GetParam();
    for (const char* const follower : {"translating_knife", "translating_roller"})
        for (const double way : {1.0, -1.0}) {
            const Solution solution = solve(wedge(way * known.travel, way * known.inclination, follower));
            EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
            EXPECT_NEAR(solution.certificate.objective, known.objective, 1e-9) << follower;
            if (known.velocity > 0.0) {
                EXPECT_NEAR(solution.peaks.velocity.value, known.velocity, 1e-7);
            }
        }
}

INSTANTIATE_TEST_SUITE_P(References, LinearOptima,
                         testing::Values(Reference{60.0, 10.0, 1.7868607532, 1.1847925},
                                         Reference{60.0, 0.0, 0.9404892772, 0.0},
                                         Reference{50.0, 0.0, 1.0239967924, 1.4433757}));

TEST(LinearCams, TooShortTravelIsInfeasible) {
    // Any rise of 20 mm within 20 mm of travel has s_u = 1 somewhere: tan φ >= 1.
    const Solution solution = solve(wedge(20.0, 0.0));
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
}

TEST(LinearCams, ShortestTravelMatchesSlowestRise) {
    const auto least = [](const TestScene& scene, const std::string& key) {
        const Solution solution = solve(scene.set("objective.least", key).with("objective.least_gap = 1e-6"));
        EXPECT_TRUE(solution.least && solution.least->impossible);
        EXPECT_EQ(solution.least->verdict, Verdict::optimal);
        return solution.least->value;
    };
    // tan 30° is reached where s' is largest: V = tan φ travel / lift on the rise, a sixth of the cycle.
    const double slowest = least(wedge(200.0, 0.0), "limits.velocity");
    const double shortest = least(wedge(200.0, 0.0), "cam.travel_mm");
    EXPECT_NEAR(shortest, 6.0 * 20.0 * slowest * std::sqrt(3.0), 3e-6 * shortest);
}

TEST(LinearCams, TravelWithinRangeIsSearched) {
    const Solution solution = solve(
        wedge(60.0, 0.0).with("cam.travel_mm = { min = 200, max = 300 }", "limits.pressure_angle_deg = 30"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(solution.certificate.objective, 1.0239967924, 1e-7);  // the longest: 50 mm of the rise
}

TEST(LinearCams, ForwardCheckFindsEveryMotionAgain) {
    for (const char* const name : {"linear_press", "linear_knife", "linear_arm"}) {
        for (const double way : {1.0, -1.0}) {
            const TestScene scene = scene_named(name);
            const double travel = scene.read().cam->find("travel")->low / units::millimetre;
            const Solution solution =
                solve(scene.set("cam.travel_mm", way * travel).with("spline.segments = 12"));
            ASSERT_TRUE(solution.cam) << name;
            EXPECT_LT(check_cam(solution, {}).relative, 1e-8) << name << " " << way;
        }
    }
}

TEST(LinearCams, ForwardCheckRefutesAnotherPlate) {
    const Solution solution = solve(scene_named("linear_press").with("spline.segments = 12"));
    const MotionChain motion = cam_motion(solution);
    ForwardCheckInput input =
        forward_check_input(solution.cam->cam, motion, motion_scale(solution.scene), 2000);
    EXPECT_LT(forward_check(input).deviation, 1e-9);
    for (Eigen::Vector2d& point : input.points) point += 2e-6 * Eigen::Vector2d::UnitY();
    EXPECT_NEAR(forward_check(input).deviation, 2e-6, 1e-6);  // a steeper plate holds the roller higher
    input.follower.slide = 0.99 * *input.follower.slide;
    EXPECT_GT(forward_check(input).deviation, 1e-4);
}

TEST(LinearCams, DrivingForceIsAlongTheTravel) {
    const Solution solution = solve(scene_named("linear_press").with("spline.segments = 12"));
    const DrivenMechanism& cam = solution.cam->cam;
    const MotionScale scale = motion_scale(solution.scene);
    const double slide = cam.dimensions[0] / units::turn;
    for (const double x : {0.2, 0.5, 0.9, 1.3, 1.8}) {
        const MotionPoint at = motion_at(*solution.motion, x);
        const FollowerState state = state_of(at, scale);
        const double force =
            solution.scene.forces->force(*solution.scene.motion.speed, state, scale.unit_angle * x);
        const double normal = normal_force(cam, state, force);
        const MechanismPoint point = mechanism_point(cam, at, scale);
        // The roller presses on the plate along −n; what holds the plate against it does the work F s'.
        EXPECT_NEAR(-normal * point.normal.x() * slide, force * state.velocity, 1e-9 * std::abs(force));
        // Along its path the roller gets back the load.
        const double angle = cam.dimensions[3];
        EXPECT_NEAR(normal * point.normal.head<2>().dot(Eigen::Vector2d(std::sin(angle), std::cos(angle))),
                    force, 1e-9 * std::abs(force));
    }
}

}  // namespace linear_cams_test
}  // namespace camopt
