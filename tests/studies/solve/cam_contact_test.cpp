// SPDX-License-Identifier: MIT
// Hertz pressure and torque speak of a follower that touches its cam: limits on them make the cam regular,
// and what is reported of a cam that cannot be touched is not a number. Pressure angles where the follower
// rests.
#include "profiles/disk/disk_cam.hpp"
#include "studies/delivered/cam_report.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "studies/least/adjustment.hpp"
#include "studies/search/planned_solve.hpp"
#include "tests/studies/independent_cam.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace camopt {
namespace cam_contact_test {

using namespace testing_support;

constexpr int dense_points = 20000;

void expect_hertz_kept(Scene scene) {
    const double speed = *scene.motion.speed;
    scene.forces->speed_range =
        std::array{speed, speed};  // other speeds: TrialCases.HertzPressureHoldsFromRest
    const Solution solution = solve_without_explaining(scene, {});
    ASSERT_TRUE(solution.motion && solution.cam);
    const Verdict verdict = solution.certificate.verdict;
    ASSERT_TRUE(has_feasible_motion(verdict)) << name_of(verdict);
    const IndependentCam independent(scene, *disk_cam(solution.cam->cam));
    const double worst = densely_worst(*solution.motion, dense_points, [&](const MotionPoint& point) {
        return independent.at(point).hertz / scene.limits.hertz_pressure_max->value;
    });
    EXPECT_LE(worst, 1.0 + 1e-6);
    EXPECT_FALSE(solution.cam->summary.no_contact);
    EXPECT_NEAR(solution.cam->summary.forces->hertz_pressure->value / scene.limits.hertz_pressure_max->value,
                worst, 1e-6);
}

TEST(HertzPressure, IsSatisfiedByFlatFace) {
    expect_hertz_kept(scene_named("flat_tappet_pressed"));
}

TEST(HertzPressure, ProvesFlatFaceInfeasible) {
    const Solution solution = solve_without_explaining(
        scene_named("flat_tappet_pressed").with("limits.hertz_pressure_max_mpa = 459.7"), {});
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
}

TEST(HertzPressure, FlatFaceOnArmSatisfiesIt) {
    expect_hertz_kept(scene_named("flat_arm_pressed").with("cam.base_radius_m = 0.085"));
    const Solution broken = solve_without_explaining(scene_named("flat_arm_pressed"), {});
    EXPECT_TRUE(broken.certificate.verdict == Verdict::failed ||
                broken.certificate.verdict == Verdict::infeasible)
        << name_of(broken.certificate.verdict);
}

TEST(HertzPressure, IsSatisfiedByRoller) {
    expect_hertz_kept(scene_named("roller_pressed"));
}

TEST(TorqueLimit, ImpliesContactWithCam) {
    const Solution solution = solve_without_explaining(
        scene_named("flat_tappet_pressed").with("limits = { torque_max_nm = 1e6 }"), {});
    ASSERT_TRUE(solution.cam);
    EXPECT_GT(solution.cam->summary.regularity.value, 0.0);
    EXPECT_FALSE(solution.cam->summary.no_contact);
}

/// A least radius of 0 allows a cusp, and rounding a little less; beside a torque it does not.
TEST(TorqueLimit, PreventsCuspAllowedByZeroRadius) {
    const Solution solution = solve_without_explaining(
        scene_named("roller_pressed").with("limits = { cam_radius_min_mm = 0, torque_max_nm = 88.86 }"), {});
    ASSERT_TRUE(solution.cam);
    EXPECT_GT(solution.cam->summary.regularity.value, 0.0);
    EXPECT_FALSE(solution.cam->summary.no_contact);
    for (const ConstraintReport& row : solution.constraints) EXPECT_FALSE(row.no_contact) << row.name;
}

TEST(UndercutMargin, PreventsReversalOfFaceOnArm) {
    // So far in so short an angle that 1 + σψ' passes zero.
    const Solution solution = solve_without_explaining(
        scene_named("flat_arm_pressed")
            .with("limits = { undercut_margin = 0 }", "motion.lift_rad = 0.9", "motion.rise_rad = 0.5"),
        {});
    const Verdict verdict = solution.certificate.verdict;
    EXPECT_TRUE(verdict == Verdict::failed || verdict == Verdict::infeasible) << name_of(verdict);
}

/// An undercut flat face, and one that turns back: every figure is a number or says that there is none.
TEST(CamFigures, UnreachableFlatFaceHasNoNumbers) {
    for (const double lift : {0.3, 0.9}) {
        Scene scene = scene_named("flat_arm_pressed")
                          .with("limits = {}")
                          .set("motion.lift_rad", lift)
                          .set("motion.rise_rad", lift < 0.5 ? 1.39 : 0.5);
        const Solution solution = solve_without_explaining(scene, {});
        ASSERT_TRUE(solution.cam);
        const CamSummary& summary = solution.cam->summary;
        EXPECT_TRUE(summary.undercut());
        EXPECT_TRUE(summary.no_contact);
        for (const CamExtreme& figure : {summary.pressure_angle, *summary.convex_radius, summary.regularity,
                                         *summary.contact_offset, summary.forces->torque})
            EXPECT_FALSE(std::isnan(figure.value));
        EXPECT_TRUE(std::isinf(summary.forces->hertz_pressure->value));
        EXPECT_TRUE(std::isinf(summary.forces->normal_force->value));
        EXPECT_FALSE(summary.regularity.value > 0.0);
        // A limit on what does not exist is not kept, and says why.
        scene.limits.hertz_pressure_max = WrittenLimit{5e9, "limits.hertz_pressure_max_mpa", 1e6, "MPa"};
        const auto rows = cam_constraints(scene, *solution.cam);
        ASSERT_EQ(rows.size(), 1U);
        EXPECT_TRUE(rows[0].no_contact);
        EXPECT_FALSE(outcome_of(scene, &*solution.cam, rows[0]).kept);
    }
}

TestScene resting_arm(double general_deg) {
    return scene_named("arm_resting_at_29_deg").set("limits.pressure_angle_deg", general_deg);
}

TEST(PressureAtRest, UsesSmallestOfThreeLimits) {
    const std::string program =
        "motion = { type = 'program', lift_rad = 0.1858, segments = ["
        "{ kind = 'dwell', angle_deg = 60 }, { kind = 'spline', angle_deg = 120, to = 1 },"
        "{ kind = 'dwell', angle_deg = 60 }, { kind = 'spline', angle_deg = 120, to = 0 }] }";
    for (const std::string& motion :
         {std::string("motion.type = DRD"), std::string("motion.type = RR"), program}) {
        const Solution broken = solve_without_explaining(resting_arm(26.4).with(motion), {});
        EXPECT_EQ(broken.certificate.verdict, Verdict::infeasible);
        const Solution kept = solve_without_explaining(resting_arm(29.5).with(motion), {});
        EXPECT_NE(kept.certificate.verdict, Verdict::infeasible);
        ASSERT_TRUE(kept.motion);
        ASSERT_EQ(kept.constraints.size(), 3U);
        EXPECT_EQ(kept.constraints[0].name, "pressure_angle");
        EXPECT_NEAR(kept.constraints[0].worst, 28.96, 0.01);
    }
}

TEST(PressureAtRest, IsSatisfiedByFreeDimensions) {
    const Scene scene = resting_arm(26.4).with("cam.arm_length_m = { min = 0.055, max = 0.0668 }");
    const Solution solution = solve_without_explaining(scene, {});
    ASSERT_TRUE(solution.cam) << name_of(solution.certificate.verdict);
    for (const double x : {0.0, 1.0}) {
        const CamContact contact =
            IndependentCam(scene, *disk_cam(solution.cam->cam)).at(solution.motion->at(x, Side::right));
        EXPECT_LE(contact.pressure, scene.limits.pressure_angle->value * (1.0 + 1e-6)) << "at x = " << x;
    }
}

TEST(PressureAtRest, OffsetFollowerUsesGeneralLimit) {
    // 30° at rest.
    for (const char* cam : {"cam = { type = 'disk', follower = 'translating_roller', base_radius_mm = 30,"
                            " roller_radius_mm = 10, offset_mm = 20 }",
                            "cam = { type = 'disk', follower = 'translating_knife', base_radius_mm = 30,"
                            " offset_mm = 15 }"}) {
        const TestScene scene =
            scene_named("drd_cubic_12")
                .with("motion.lift_mm = 20", "motion.rise_rad = 2", "limits.rise_pressure_angle_deg = 45",
                      "limits.return_pressure_angle_deg = 45", cam);
        const auto verdict = [&](double limit) {
            return solve_without_explaining(scene.set("limits.pressure_angle_deg", limit), {})
                .certificate.verdict;
        };
        EXPECT_EQ(verdict(25.0), Verdict::infeasible);
        EXPECT_EQ(verdict(31.0), Verdict::optimal);
    }
}

TEST(PressureAtRest, IsSuggestedWhereItMatters) {
    const auto offered = [](double general) {
        for (const Adjustment& adjustment : adjustments(resting_arm(general)))
            if (adjustment.key == "limits.pressure_angle_deg") return true;
        return false;
    };
    EXPECT_TRUE(offered(26.4));
    EXPECT_FALSE(offered(40.0));  // replaced on both strokes and not the least at rest: it says nothing
}

}  // namespace cam_contact_test
}  // namespace camopt
