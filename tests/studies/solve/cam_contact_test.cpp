// SPDX-License-Identifier: MIT
// Hertz pressure and torque speak of a follower that touches its cam: limits on them make the cam regular,
// and what is reported of a cam that cannot be touched is not a number. Pressure angles where the follower
// rests.
#include "profiles/disk/disk_cam.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "studies/delivered/solution_report.hpp"
#include "studies/explain/adjustment.hpp"
#include "studies/search/planned_solve.hpp"
#include "tests/studies/cam_scenes.hpp"
#include "tests/studies/independent_cam.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

namespace camopt {
namespace cam_contact_test {

using namespace testing_support;
using enum DimensionIndex;

constexpr int dense_points = 20000;

Scene pressed_scene(FollowerType follower) {
    Scene scene;
    scene.cam = disk_spec({.follower = follower});
    scene.solver.starts = 2;
    scene.solver.max_seconds = 20.0;
    ForceSpec& forces = scene.forces.emplace();
    forces.contact_width = 0.01;
    return scene;
}

WrittenLimit megapascals(double value) {
    return {value * 1e6, "limits.hertz_pressure_max_mpa", 1e6, "MPa"};
}

/// A flat tappet whose optimum without limits undercuts by two thirds of its base radius.
Scene flat_scene_under_pressure(double limit_mpa) {
    Scene scene = pressed_scene(FollowerType::translating_flat);
    scene.motion.lift = 0.0513;
    scene.motion.rise = 1.0441;
    scene.motion.speed = 87.48;
    scene.spline.segments = 10;
    scene.objective.velocity = 0.503;
    scene.objective.acceleration = 0.418;
    scene.objective.jerk = 0.0913;
    scene.cam->set(base_radius, 0.13678);
    scene.forces->mass = 2.679;
    scene.forces->spring_rate = 162445.0;
    scene.forces->preload = 2488.3;
    scene.limits.hertz_pressure_max = megapascals(limit_mpa);
    return scene;
}

/// A flat face on an arm, rise and return; without limits it undercuts by 2.7 base radii.
Scene flat_arm_under_pressure(double base) {
    Scene scene = pressed_scene(FollowerType::oscillating_flat);
    scene.motion.type = MotionType::rr;
    scene.motion.lift_is_angle = true;
    scene.motion.lift = 0.30657;
    scene.motion.rise = 1.3916;
    scene.motion.speed = 59.485;
    scene.spline.segments = 16;
    scene.objective.velocity = 0.3136;
    scene.objective.acceleration = 0.8195;
    scene.objective.jerk = 0.4287;
    scene.cam->rotation = Rotation::clockwise;
    scene.cam->set(base_radius, base);
    scene.cam->set(center_distance, 0.16773);
    scene.forces->mass = 0.02704;
    scene.forces->spring_rate = 365.45;
    scene.forces->preload = 102.8;
    scene.limits.hertz_pressure_max = megapascals(2365.4);
    return scene;
}

/// A roller whose cam comes to a cusp on the return.
Scene roller_under_pressure(double limit_mpa) {
    Scene scene = pressed_scene(FollowerType::translating_roller);
    scene.motion.type = MotionType::rr;
    scene.motion.lift = 0.015745;
    scene.motion.rise = 0.80446;
    scene.motion.speed = 79.945;
    scene.spline.segments = 12;
    scene.objective.velocity = 0.7561;
    scene.objective.acceleration = 0.6605;
    scene.objective.jerk = 0.3113;
    scene.cam->set(base_radius, 0.027401);
    scene.cam->set(roller_radius, 0.019809);
    scene.cam->set(offset, -0.011157);
    scene.forces->mass = 2.1166;
    scene.forces->spring_rate = 127893.6;
    scene.forces->preload = 1862.1;
    scene.limits.hertz_pressure_max = megapascals(limit_mpa);
    return scene;
}

void expect_hertz_kept(Scene scene) {
    const double speed = *scene.motion.speed;
    scene.forces->speed_range =
        std::array{speed, speed};  // other speeds: TrialCases.HertzPressureHoldsFromRest
    const Solution solution = solve_without_explaining(scene, {});
    ASSERT_TRUE(solution.motion && solution.cam);
    const Verdict verdict = solution.certificate.verdict;
    ASSERT_TRUE(verdict == Verdict::optimal || verdict == Verdict::local || verdict == Verdict::feasible)
        << name_of(verdict);
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
    expect_hertz_kept(flat_scene_under_pressure(720.0));
}

TEST(HertzPressure, ProvesFlatFaceInfeasible) {
    const Solution solution = solve_without_explaining(flat_scene_under_pressure(459.7), {});
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
}

TEST(HertzPressure, FlatFaceOnArmSatisfiesIt) {
    expect_hertz_kept(flat_arm_under_pressure(0.085));
    const Solution broken = solve_without_explaining(flat_arm_under_pressure(0.0607), {});
    EXPECT_TRUE(broken.certificate.verdict == Verdict::failed ||
                broken.certificate.verdict == Verdict::infeasible)
        << name_of(broken.certificate.verdict);
}

TEST(HertzPressure, IsSatisfiedByRoller) {
    expect_hertz_kept(roller_under_pressure(2400.0));
}

TEST(TorqueLimit, ImpliesContactWithCam) {
    Scene scene = flat_scene_under_pressure(720.0);
    scene.limits.hertz_pressure_max.reset();
    scene.limits.torque_max = WrittenLimit{1e6, "limits.torque_max_nm", 1.0, "N m"};
    const Solution solution = solve_without_explaining(scene, {});
    ASSERT_TRUE(solution.cam);
    EXPECT_GT(solution.cam->summary.regularity.value, 0.0);
    EXPECT_FALSE(solution.cam->summary.no_contact);
}

/// A least radius of 0 allows a cusp, and rounding a little less; beside a torque it does not.
TEST(TorqueLimit, PreventsCuspAllowedByZeroRadius) {
    Scene scene = roller_under_pressure(2400.0);
    scene.limits.hertz_pressure_max.reset();
    scene.limits.cam_radius_min = millimetres(0.0, "limits.cam_radius_min_mm");
    scene.limits.torque_max = WrittenLimit{88.86, "limits.torque_max_nm", 1.0, "N m"};
    const Solution solution = solve_without_explaining(scene, {});
    ASSERT_TRUE(solution.cam);
    EXPECT_GT(solution.cam->summary.regularity.value, 0.0);
    EXPECT_FALSE(solution.cam->summary.no_contact);
    for (const ConstraintReport& row : solution.constraints) EXPECT_FALSE(row.no_contact) << row.name;
}

TEST(UndercutMargin, PreventsReversalOfFaceOnArm) {
    Scene scene = flat_arm_under_pressure(0.0607);
    scene.limits.hertz_pressure_max.reset();
    scene.limits.undercut_margin = WrittenLimit{0.0, "limits.undercut_margin", 1.0, ""};
    scene.motion.lift = 0.9;  // so far in so short an angle that 1 + σψ' passes zero
    scene.motion.rise = 0.5;
    const Solution solution = solve_without_explaining(scene, {});
    const Verdict verdict = solution.certificate.verdict;
    EXPECT_TRUE(verdict == Verdict::failed || verdict == Verdict::infeasible) << name_of(verdict);
}

/// An undercut flat face, and one that turns back: every figure is a number or says that there is none.
TEST(CamFigures, UnreachableFlatFaceHasNoNumbers) {
    for (const double lift : {0.3, 0.9}) {
        Scene scene = flat_arm_under_pressure(0.0607);
        scene.limits.hertz_pressure_max.reset();
        scene.motion.lift = lift;
        scene.motion.rise = lift < 0.5 ? 1.39 : 0.5;
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
        scene.limits.hertz_pressure_max = megapascals(5000.0);
        const auto rows = cam_constraints(scene, *solution.cam);
        ASSERT_EQ(rows.size(), 1U);
        EXPECT_TRUE(rows[0].no_contact);
        EXPECT_FALSE(outcome_of(scene, &*solution.cam, rows[0]).kept);
    }
}

/// At rest 29°: an arm whose pressure angle does not vanish there.
Scene resting_arm(double general_deg, MotionType type) {
    Scene scene;
    paper_weights(scene);
    scene.motion.type = type;
    scene.motion.lift_is_angle = true;
    scene.motion.lift = 0.1858;
    scene.motion.rise = 2.527;
    scene.spline.segments = 10;
    scene.cam = disk_spec({.follower = FollowerType::oscillating_roller});
    scene.cam->rotation = Rotation::clockwise;
    scene.cam->set(base_radius, 0.045157);
    scene.cam->set(roller_radius, 0.010807);
    scene.cam->set(center_distance, 0.067974);
    scene.cam->set(arm_length, 0.066768);
    scene.limits.pressure_angle = degrees(general_deg, "limits.pressure_angle_deg");
    scene.limits.rise_pressure_angle = degrees(36.0, "limits.rise_pressure_angle_deg");
    scene.limits.return_pressure_angle = degrees(34.4, "limits.return_pressure_angle_deg");
    if (type != MotionType::program) return scene;
    for (const auto& [kind, angle, to] :
         {std::tuple{SegmentKind::dwell, 60.0, 0.0}, std::tuple{SegmentKind::spline, 120.0, 1.0},
          std::tuple{SegmentKind::dwell, 60.0, 1.0}, std::tuple{SegmentKind::spline, 120.0, 0.0}}) {
        ProgramSegment segment;
        segment.kind = kind;
        segment.angle = angle * units::degree;
        if (kind == SegmentKind::spline) segment.to = to;
        scene.motion.segments.push_back(segment);
    }
    return scene;
}

TEST(PressureAtRest, UsesSmallestOfThreeLimits) {
    for (const MotionType type : {MotionType::drd, MotionType::rr, MotionType::program}) {
        const Solution broken = solve_without_explaining(resting_arm(26.4, type), {});
        EXPECT_EQ(broken.certificate.verdict, Verdict::infeasible);
        const Solution kept = solve_without_explaining(resting_arm(29.5, type), {});
        EXPECT_NE(kept.certificate.verdict, Verdict::infeasible);
        ASSERT_TRUE(kept.motion);
        ASSERT_EQ(kept.constraints.size(), 3U);
        EXPECT_EQ(kept.constraints[0].name, "pressure_angle");
        EXPECT_NEAR(kept.constraints[0].worst, 28.96, 0.01);
    }
}

TEST(PressureAtRest, IsSatisfiedByFreeDimensions) {
    Scene scene = resting_arm(26.4, MotionType::drd);
    scene.cam->set(arm_length, {0.055, 0.0668});
    const Solution solution = solve_without_explaining(scene, {});
    ASSERT_TRUE(solution.cam) << name_of(solution.certificate.verdict);
    for (const double x : {0.0, 1.0}) {
        const CamContact contact =
            IndependentCam(scene, *disk_cam(solution.cam->cam)).at(solution.motion->at(x, Side::right));
        EXPECT_LE(contact.pressure, scene.limits.pressure_angle->value * (1.0 + 1e-6)) << "at x = " << x;
    }
}

TEST(PressureAtRest, OffsetFollowerUsesGeneralLimit) {
    for (const FollowerType follower : {FollowerType::translating_roller, FollowerType::translating_knife}) {
        Scene scene;
        paper_weights(scene);
        scene.motion.lift = 0.02;
        scene.motion.rise = 2.0;
        scene.cam = disk_spec({.follower = follower});
        scene.cam->set(base_radius, 0.03);
        if (has_roller(follower)) scene.cam->set(roller_radius, 0.01);
        scene.cam->set(offset, follower == FollowerType::translating_knife ? 0.015 : 0.02);  // 30° at rest
        scene.limits.rise_pressure_angle = degrees(45.0, "limits.rise_pressure_angle_deg");
        scene.limits.return_pressure_angle = degrees(45.0, "limits.return_pressure_angle_deg");
        scene.limits.pressure_angle = degrees(25.0, "limits.pressure_angle_deg");
        EXPECT_EQ(solve_without_explaining(scene, {}).certificate.verdict, Verdict::infeasible);
        scene.limits.pressure_angle = degrees(31.0, "limits.pressure_angle_deg");
        EXPECT_EQ(solve_without_explaining(scene, {}).certificate.verdict, Verdict::optimal);
    }
}

TEST(PressureAtRest, IsSuggestedWhereItMatters) {
    const auto offered = [](double general) {
        for (const Adjustment& adjustment : adjustments(resting_arm(general, MotionType::drd)))
            if (adjustment.key == "limits.pressure_angle_deg") return true;
        return false;
    };
    EXPECT_TRUE(offered(26.4));
    EXPECT_FALSE(offered(40.0));  // replaced on both strokes and not the least at rest: it says nothing
}

}  // namespace cam_contact_test
}  // namespace camopt
