// SPDX-License-Identifier: MIT
// The example scenes with two sides: every limit, looked at again at many cam angles on either side by the
// points alone, and what is reported beside it.
#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "studies/check/check_cam.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace camopt {
namespace two_sided_cams_test {

/// From two starts and with a loose bound: what is looked at holds for any motion that is delivered.
Solution solved(const std::string& name) {
    return testing_support::solved(
        testing_support::scene_named(name).with("solver.starts = 2", "solver.gap = 1e-2"));
}

/// Largest and least figures of one side, from its points and the roller alone.
struct Seen {
    double pressure_angle = 0.0, convex = 1e9, concave = 1e9, hertz = 0.0, normal = 0.0;
};

Seen look_at(const Solution& solution, int side) {
    const DiskCam cam = disk_cam(solution.cam->cam).value();
    const MotionScale scale = motion_scale(solution.scene);
    const Scene& scene = solution.scene;
    const double roller = roller_radius_of(cam, side);
    Seen seen;
    for (int i = 0; i <= 8000; ++i) {
        const double x = solution.motion->end() * i / 8000.0;
        const FollowerState state =
            state_of(solution.motion->at(x, x < solution.motion->end() ? Side::right : Side::left), scale);
        const ProfilePoint point = profile_point(cam, scale.unit_angle * x, state, side);
        seen.pressure_angle = std::max(seen.pressure_angle, std::abs(point.pressure_angle));
        if (point.cam_radius > 0.0)
            seen.convex = std::min(seen.convex, point.cam_radius);
        else
            seen.concave = std::min(seen.concave, -point.cam_radius);
        const double force =
            (side == 0 ? 1.0 : -1.0) * scene.forces->force(*scene.motion.speed, state, scale.unit_angle * x);
        if (!(force > 0.0)) continue;
        const double lever = std::cos(point.pressure_angle) *
                             (is_oscillating(cam.follower) ? cam[DimensionIndex::arm_length] : 1.0);
        const double normal = force / lever, curvature = 1.0 / roller + 1.0 / point.cam_radius;
        seen.normal = std::max(seen.normal, normal);
        seen.hertz = std::max(seen.hertz, std::sqrt(normal * curvature /
                                                    (scene.forces->compliance() * std::numbers::pi *
                                                     *scene.forces->contact_width)));
    }
    return seen;
}

class TwoSidedScene : public testing::TestWithParam<const char*> {};

TEST_P(TwoSidedScene, SatisfiesLimitsOnEitherSide) {
    const Solution solution = solved(GetParam());
    ASSERT_TRUE(solution.motion) << solution.certificate.reason;
    ASSERT_EQ(solution.cam->summary.sides.size(), 2U);
    const LimitSpec& limits = solution.scene.limits;
    double hertz = 0.0, convex = 1e9;
    for (int side = 0; side < 2; ++side) {
        const Seen seen = look_at(solution, side);
        const SideSummary& told = solution.cam->summary.sides[static_cast<std::size_t>(side)];
        EXPECT_LE(seen.pressure_angle, limits.pressure_angle->value * (1.0 + 1e-7));
        EXPECT_GE(seen.convex, limits.cam_radius_min->value * (1.0 - 1e-7));
        EXPECT_LE(seen.hertz, limits.hertz_pressure_max->value * (1.0 + 1e-7));
        EXPECT_NEAR(told.pressure_angle.value, seen.pressure_angle, 1e-6);
        ASSERT_TRUE(told.hertz_pressure && told.normal_force);
        EXPECT_GT(seen.normal, 0.0) << "this side carries nothing";
        EXPECT_NEAR(told.hertz_pressure->value / seen.hertz, 1.0, 1e-5);
        EXPECT_NEAR(told.normal_force->value / seen.normal, 1.0, 1e-5);
        if (told.convex_radius && told.convex_radius->value < 1.0) {
            EXPECT_NEAR(told.convex_radius->value / seen.convex, 1.0, 1e-5);
        }
        if (told.concave_radius && told.concave_radius->value < 1.0) {
            EXPECT_NEAR(told.concave_radius->value / seen.concave, 1.0, 1e-5);
        }
        hertz = std::max(hertz, seen.hertz);
        convex = std::min(convex, seen.convex);
    }
    EXPECT_NEAR(solution.cam->summary.forces->hertz_pressure->value / hertz, 1.0, 1e-5);
    EXPECT_NEAR(solution.cam->summary.convex_radius->value / convex, 1.0, 1e-5);
    const ForwardCheckReport check = check_cam(solution);
    EXPECT_LT(check.relative, 1e-9);
    ASSERT_TRUE(check.play.has_value());
    EXPECT_GT(check.play->least, -1e-9);
}

INSTANTIATE_TEST_SUITE_P(Scenes, TwoSidedScene, testing::Values("cam_grooved", "cam_conjugate"),
                         [](const auto& one) { return std::string(one.param); });

}  // namespace two_sided_cams_test
}  // namespace camopt
