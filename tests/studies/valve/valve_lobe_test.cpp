// SPDX-License-Identifier: MIT
// Valve lobes: duration met exactly, events and areas against sums, proof, explanation, two lobes of one
// shaft.
#include "core/units.hpp"
#include "scene/written_limits.hpp"
#include "studies/valve/valve_report.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace camopt {
namespace valve_lobe_test {

using namespace testing_support;
using units::degree;
using units::millimetre;

/// Solved once for all that look at it.
const Solution& lobe() {
    return solved(scene_named("valve_lobe"));
}

TEST(ValveLobe, DurationIsMetExactly) {
    EXPECT_EQ(lobe().certificate.verdict, Verdict::optimal) << name_of(lobe().certificate.reason);
    const ValveReport report = valve_report(lobe());
    ASSERT_EQ(report.events.size(), 5U);
    const ValveEvent& checking = report.at(0.15 * millimetre);
    EXPECT_NEAR(checking.duration() / degree, 248.0, 1e-9);
    EXPECT_NEAR(checking.opens / degree, -124.0, 1e-9);
}

TEST(ValveLobe, RampsHaveTheirHeightsAndVelocities) {
    const Solution& solution = lobe();
    const ValveSpec& valve = *solution.scene.motion.valve;
    const MotionSpec& motion = solution.scene.motion;
    // Lash is taken up on the ramps: 0.2 of 0.3 mm.
    const ValveReport report = valve_report(solution);
    EXPECT_NEAR(report.opening_velocity * degree / millimetre, 0.012, 1e-12);
    EXPECT_NEAR(report.closing_velocity * degree / millimetre, 0.010, 1e-12);
    const double end = motion.segments[0].angle + motion.segments[1].angle;
    const MotionPoint there = solution.motion->at(end / motion.unit_angle());
    EXPECT_NEAR(there.derivative[0] * motion.lift / millimetre, 0.30, 1e-12);
    // From the ramp's end to the checking point: 0.05 mm = 0.012 mm/deg t + 60 · 9.7 mm / (62 deg)³ t³ / 6.
    const double t = (nose_angle(valve) - end) / degree - 62.0;
    EXPECT_NEAR(0.012 * t + 10.0 * 9.7 / std::pow(62.0, 3) * std::pow(t, 3), 0.05, 1e-12);
    EXPECT_NEAR(valve_lift_at(solution, nose_angle(valve) / motion.unit_angle()) / millimetre, 9.5, 1e-12);
}

TEST(ValveLobe, CheckingPointMayLieOnRamp) {
    const Solution solution =
        optimum_of(scene_named("valve_lobe").with("motion.lash_mm = 0", "motion.duration_crank_deg = 290"));
    EXPECT_TRUE(solution.scene.motion.segments[2].via.empty());
    EXPECT_NEAR(valve_report(solution).at(0.15 * millimetre).duration() / degree, 290.0, 1e-9);
}

TEST(ValveLobe, AreaIsThatOfMidpoints) {
    const Solution& solution = lobe();
    for (const ValveEvent& event : valve_report(solution).events) {
        constexpr int steps = 200000;
        double sum = 0.0;
        for (int i = 0; i < steps; ++i)
            sum += valve_lift_at(
                solution, x_of_crank_angle(solution, event.opens + event.duration() * (i + 0.5) / steps));
        EXPECT_NEAR(sum * event.duration() / steps / event.area, 1.0, 1e-9);
        EXPECT_NEAR(valve_lift_at(solution, x_of_crank_angle(solution, event.opens)), event.height, 1e-15);
    }
}

TEST(ValveLobe, AccelerationsStayWithinTheirSides) {
    const ValveReport report = valve_report(lobe());
    const double unit = millimetre / (degree * degree);
    EXPECT_NEAR(report.opening_acceleration / unit, 0.020, 1e-8);
    EXPECT_NEAR(report.nose_acceleration / unit, -0.0085, 1e-8);
    EXPECT_LE(report.closing_acceleration / unit, 0.020 + 1e-8);
}

TEST(ValveLobe, LimitsByAngleAndInTime) {
    // 3250 rpm of the cam: 19500 deg/s.
    const Solution in_time =
        optimum_of(scene_named("valve_lobe")
                       .with("limits.acceleration_mm_s2 = { min = -3232125, max = 7605000 }",
                             "limits.jerk_mm_s3 = 37074375000"));
    EXPECT_NEAR(lobe().certificate.objective, in_time.certificate.objective, 1e-9);
}

TEST(ValveLobe, RockerRatioScalesTheFollower) {
    const Solution solution = optimum_of(scene_named("valve_lobe").with("motion.rocker_ratio = 1.6"));
    EXPECT_NEAR(solution.scene.motion.lift, 9.7 * millimetre / 1.6, 1e-15);
    EXPECT_NEAR(valve_report(solution).at(0.15 * millimetre).duration() / degree, 248.0, 1e-9);
}

TEST(ValveLobe, FingerFollowerSwings) {
    const Solution solution = optimum_of(
        scene_named("valve_lobe")
            .with("motion = { type = 'valve', lift_mm = 9.5, valve_arm_mm = 40, duration_crank_deg = 248, "
                  "checking_height_mm = 1, opening_ramp = { height_deg = 0.4, velocity_deg_deg = 0.02 } }",
                  "cam = { type = 'disk', follower = 'oscillating_roller', base_radius_mm = 18, "
                  "roller_radius_mm = 9, "
                  "arm_length_mm = 32, center_distance_mm = 44 }",
                  "spline.segments = 12", "objective = { acceleration = 1 }", "limits = {}"));
    EXPECT_TRUE(solution.scene.motion.lift_is_angle);
    EXPECT_NEAR(solution.scene.motion.lift, 9.5 / 40.0, 1e-15);
    EXPECT_NEAR(valve_report(solution).at(millimetre).duration() / degree, 248.0, 1e-9);
}

TEST(ValveLobe, WithoutMotionExplanationNamesDuration) {
    const TestScene scene = scene_named("valve_lobe")
                                .with("limits.acceleration_mm_deg2 = { min = -0.0085, max = 0.006 }",
                                      "solver = { explain_seconds = 20, explain_changes = 10 }");
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    const auto longer = std::ranges::find(solution.relaxation, "motion.duration_crank_deg", &Relaxation::key);
    ASSERT_NE(longer, solution.relaxation.end());
    ASSERT_TRUE(longer->solved);
    // There a motion just exists; whether it is proved to be the best of them depends on the backends.
    EXPECT_TRUE(has_feasible_motion(solve(scene.set(longer->key, *longer->solved)).certificate.verdict))
        << *longer->solved;
    for (const Relaxation& change : solution.relaxation)
        EXPECT_EQ(change.key.find("segments["), std::string::npos) << change.key;
}

TEST(ValveLobe, LiftOffSpeedLeavesNoForce) {
    const Solution solution =
        optimum_of(scene_named("valve_lobe")
                       .with("cam = { type = 'disk', follower = 'translating_flat', base_radius_mm = 17 }",
                             "forces = { mass_kg = 0.11, spring_rate_n_mm = 28, preload_n = 260 }"));
    const ValveReport report = valve_report(solution);
    ASSERT_EQ(report.margins.size(), 5U);
    for (std::size_t i = 1; i < report.margins.size(); ++i)
        EXPECT_LT(report.margins[i].least().least_force, report.margins[i - 1].least().least_force);
    ASSERT_TRUE(report.lift_off_speed);
    // F = m ω² s'' + c s + F0 over samples: never below 0 at that speed, but for the sampling.
    const double speed = 0.5 * *report.lift_off_speed;
    const MotionSpec& motion = solution.scene.motion;
    double least = infinity;
    for (int i = 0; i <= 20000; ++i) {
        const MotionPoint point = solution.motion->at(
            solution.motion->begin() + (solution.motion->end() - solution.motion->begin()) * i / 20000);
        const double s = motion.lift * point.derivative[0];
        const double a = motion.lift * point.derivative[2] / std::pow(motion.unit_angle(), 2);
        least = std::min(least, 0.11 * speed * speed * a + 28000.0 * s + 260.0);
    }
    EXPECT_GE(least, -1e-6);
    EXPECT_LE(least, 0.5);
    ASSERT_TRUE(report.nose_radius);
    // Flat face: base radius + displacement + acceleration, between the places of the largest velocities.
    const double top = nose_angle(*motion.valve) / motion.unit_angle();
    const auto derivative_at = [&](double x, int order) {
        return motion.lift * solution.motion->at(x).derivative[order] / std::pow(motion.unit_angle(), order);
    };
    const double cam_speed = 0.5 * report.margins[2].engine_speed;
    double radius = infinity, on_nose = infinity, on_flank = infinity, nose_at = 0.0;
    for (const double end : {solution.motion->begin(), solution.motion->end()}) {
        constexpr int samples = 40000;
        std::vector<double> places;
        for (int i = 0; i <= samples; ++i)
            places.push_back(std::lerp(top, end, static_cast<double>(i) / samples));
        const auto fastest =
            std::ranges::max_element(places, {}, [&](double x) { return std::abs(derivative_at(x, 1)); });
        for (auto x = places.begin(); x != places.end(); ++x) {
            const double s = derivative_at(*x, 0), bend = derivative_at(*x, 2);
            if (x < fastest && 17e-3 + s + bend < radius) {
                radius = 17e-3 + s + bend;
                nose_at = *x;
            }
            double& part = x < fastest ? on_nose : on_flank;
            part = std::min(part, 0.11 * cam_speed * cam_speed * bend + 28000.0 * s + 260.0);
        }
    }
    EXPECT_NEAR(x_of_crank_angle(solution, report.nose_radius->at), nose_at, 1e-3);
    EXPECT_LT(radius, 17e-3 + 9.7e-3 + derivative_at(top, 2) - 1e-6);
    EXPECT_NEAR(report.nose_radius->value, radius, 2e-6);
    EXPECT_NEAR(report.margins[2].nose.least_force, on_nose, 0.1);
    EXPECT_NEAR(report.margins[2].flank.least_force, on_flank, 0.1);
}

TEST(ValveLobe, StructuredSolverNeedsNoSuccessor) {
    // Rows of the limits meet in nearly dependent places: a direction must be more accurate than its length
    // asks.
    const TestScene scene =
        scene_named("valve_lobe")
            .with(
                "limits = { acceleration_mm_deg2 = { min = -0.012, max = 0.020 }, jerk_mm_deg3 = 0.005, "
                "contact_force_min_n = 60, cam_radius_min_mm = 2 }",
                "cam = { type = 'disk', follower = 'translating_flat', base_radius_mm = 18, face_radius_mm = "
                "16 }",
                "forces = { mass_kg = 0.11, spring_rate_n_mm = 28, preload_n = 260, contact_width_mm = 13 }",
                "solver.name = structured");
    for (const int segments : {20, 24, 28, 32}) {
        const Solution solution = optimum_of(scene.set("spline.segments", segments));
        EXPECT_LE(*solution.certificate.gap, 2e-7) << segments;
    }
}

TEST(ValveLobe, OverlapOfIntakeAndExhaust) {
    const auto with_centerline = [](int number) {
        return optimum_of(scene_named("valve_lobe").set("motion.centerline_crank_deg", number));
    };
    const Solution intake = with_centerline(108), exhaust = with_centerline(-112);
    const ValvePair pair = valve_pair(intake, exhaust, ValveGap{4.0 * millimetre, 30.0 * degree});
    EXPECT_NEAR(pair.lobe_separation / degree, 110.0, 1e-9);
    const auto checking = std::ranges::find_if(
        pair.overlaps, [](const auto& one) { return std::abs(one.height - 0.15 * millimetre) < 1e-9; });
    ASSERT_NE(checking, pair.overlaps.end());
    // Opens 108 − 124, closes −112 + 124.
    EXPECT_NEAR(checking->opens / degree, -16.0, 1e-9);
    EXPECT_NEAR(checking->closes / degree, 12.0, 1e-9);
    EXPECT_NEAR(checking->duration() / degree, 28.0, 1e-9);
    // Symmetric but for the ramps: both are equally open about 2 degrees before top dead centre.
    EXPECT_NEAR(pair.common_at / degree, -2.0, 2.0);
    EXPECT_GT(pair.common_lift, 0.15 * millimetre);
    ASSERT_TRUE(pair.clearance);
    const double both = 2.0 * pair.common_lift * std::sin(15.0 * degree);
    EXPECT_NEAR(*pair.clearance, 4.0 * millimetre - both, 0.1 * millimetre);
    EXPECT_THROW(static_cast<void>(valve_pair(intake, lobe())), InputError);
}

TEST(ValveLobe, IsWrittenInCppToo) {
    ValveSpec valve;
    valve.lift = 9.5 * millimetre;
    valve.lash = 0.2 * millimetre;
    valve.checking_height = 0.15 * millimetre;
    valve.duration = 124.0 * degree;
    valve.opening = 62.0 * degree;
    valve.opening_ramp = {0.30 * millimetre, 0.012 * millimetre / degree, {}};
    valve.closing_ramp = {0.30 * millimetre, 0.010 * millimetre / degree, {}};
    Scene scene;
    make_valve_lobe(scene.motion, valve);
    scene.spline.segments = 16;
    scene.objective.area = 1.0;
    scene.limits.acceleration_min = millimetres_per_degree_squared(-0.0085);
    scene.limits.acceleration_max = millimetres_per_degree_squared(0.020);
    scene.limits.jerk = millimetres_per_degree_cubed(0.005);
    EXPECT_NEAR(solve(scene).certificate.objective, lobe().certificate.objective, 1e-9);
    valve.checking_height = 0.0;
    EXPECT_THROW(make_valve_lobe(scene.motion, valve), InputError);
}

}  // namespace valve_lobe_test
}  // namespace camopt
