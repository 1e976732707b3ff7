// SPDX-License-Identifier: MIT
// The parts of an explanation: values told on the side that does, finer splines, what no motion can keep,
// limits that give way together, and the time it may take.
#include "profiles/disk/disk_cam.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/explain/explain.hpp"
#include "studies/least/adjustment.hpp"
#include "studies/least/feasible_edge.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/middle_cam.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace camopt {
namespace relaxation_test {

using namespace testing_support;
using enum DimensionIndex;

const Relaxation* row_of(const Solution& solution, const std::string& key) {
    const auto found = std::ranges::find(solution.relaxation, key, &Relaxation::key);
    return found == solution.relaxation.end() ? nullptr : &*found;
}

TEST(SafeValue, ExceedsEdgeByMillionthOrDigit) {
    EXPECT_EQ(safe_value(33.7191, true, 0.0), 33.72);
    EXPECT_EQ(safe_value(33.7191, false, 0.0), 33.719);
    EXPECT_EQ(safe_value(1.2, true, 0.0), 1.2001) << "the edge itself is no value to tell";
    EXPECT_EQ(safe_value(7.6e-9, true, 0.4), 1e-5) << "digits of the size, not of a number near 0";
    EXPECT_EQ(safe_value(-1.25, false, 0.0), -1.2501);
    std::mt19937 engine(7);
    for (int trial = 0; trial < 2000; ++trial) {
        const double power = static_cast<double>(engine() % 17) - 8.0;
        const double value = std::pow(10.0, power) * (1.0 + static_cast<double>(engine() % 90000) * 1e-4);
        const double up = safe_value(value, true, 0.0), down = safe_value(value, false, 0.0);
        EXPECT_GE(up, value * (1.0 + 0.99e-6));
        EXPECT_LE(up, value * (1.0 + 1.02e-4));
        EXPECT_LE(down, value * (1.0 - 0.99e-6));
        EXPECT_GE(down, value * (1.0 - 1.02e-4));
    }
}

TEST(FinerSpline, HalvesGivenBreakpoints) {
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    scene.spline.breakpoints = {0.0, 0.2, 0.6, 1.0};
    const Scene finer = with_segments(scene, 6);
    EXPECT_EQ(finer.spline.breakpoints, (std::vector<double>{0.0, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0}));
    EXPECT_EQ(segments_of(with_segments(scene, 7).spline), 12);
}

TEST(FinerSpline, IsFewestSegmentsSolved) {
    const Scene scene = scene_named("drd_cubic_4").with("spline.degree = 5", "limits.acceleration = 5");
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    const Relaxation* row = row_of(solution, "spline.segments");
    ASSERT_TRUE(row && row->needed);
    EXPECT_EQ(row->given, 4.0);
    const int segments = static_cast<int>(*row->needed);
    EXPECT_GT(segments, 4);
    EXPECT_TRUE(solve(with_segments(scene, segments)).motion);
    EXPECT_FALSE(solve(with_segments(scene, segments - 1)).motion);
}

/// Fourteen uniform segments have none: what was solved are the given intervals, halved.
TEST(FinerSpline, ReportsSubdivisionOfGivenBreakpoints) {
    const TestScene scene = scene_named("finer_breakpoints");
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_FALSE(row_of(solution, "spline.segments"));
    const Relaxation* row = row_of(solution, "spline.breakpoints");
    ASSERT_TRUE(row && row->needed);
    EXPECT_EQ(*row->needed, 14.0);
    EXPECT_TRUE(solve(with_segments(scene, 14)).motion);
    EXPECT_FALSE(solve(scene.with("spline = { degree = 5, end_jerk = 'zero', segments = 14 }")).motion);
}

TEST(FinerSpline, IsNotSearchedWhereImpossible) {
    const Solution solution = solve(scene_named("drd_cubic_12").with("limits.velocity = 0.9"));
    EXPECT_FALSE(row_of(solution, "spline.segments"));
    ASSERT_TRUE(solution.explanation);
    EXPECT_EQ(solution.explanation->any_motion, std::vector<std::string>{"limits.velocity"});
    EXPECT_EQ(solution.explanation->finest, 0);
}

TEST(SmallestOfAnyMotion, UsesMostDemandingStroke) {
    // Rise 0 to 1 in 120 deg, return in two parts: 1 to 0.5 in 20 deg, 0.5 to 0 in 60 deg, with 25 deg there.
    Scene scene = pressure_angle_scene(40).with("limits.return_pressure_angle_deg = 25");
    scene.motion.type = MotionType::program;
    scene.motion.segments = {spline(120, 1.0), spline(20, 0.5), spline(60, 0.0), dwell(160)};
    const double degree = units::degree;
    const auto smallest = smallest_of_any_motion(scene, disk_mechanism(middle_cam(disk_of(*scene.cam))));
    ASSERT_TRUE(smallest);
    // r = s0 exp(θ tan φ) from s0 + 10 mm to s0 + 20 mm.
    const double needed = 10.0 / std::expm1(20 * degree * std::tan(25 * degree)) - 10.0;
    EXPECT_NEAR(smallest->prime_radius, needed * 1e-3, 1e-12);
    EXPECT_FALSE(smallest->rises);
    EXPECT_NEAR(smallest->begin, 1.0, 1e-12);
    EXPECT_EQ(smallest->key, "limits.return_pressure_angle_deg");
    EXPECT_EQ(kept_by_no_motion(scene), std::vector<std::string>{"limits.return_pressure_angle_deg"});
}

TEST(SmallestOfAnyMotion, BoundsRealMotions) {
    // A cam a little larger than the bound is kept by a spline fine enough; a smaller one by none.
    Scene scene = pressure_angle_scene(40, 48).with("motion.type = RR", "motion.rise_deg = 120",
                                                    "motion.return_deg = 60");
    const double bound =
        smallest_of_any_motion(scene, disk_mechanism(middle_cam(disk_of(*scene.cam))))->prime_radius;
    scene.cam->set(base_radius, 1.2 * bound - 10e-3);
    EXPECT_TRUE(solve(scene).motion);
    EXPECT_TRUE(kept_by_no_motion(scene).empty());
    scene.cam->set(base_radius, 0.999 * bound - 10e-3);
    EXPECT_EQ(kept_by_no_motion(scene), std::vector<std::string>{"limits.pressure_angle_deg"});
    EXPECT_FALSE(solve(scene).motion);
}

TEST(FinerSpline, IsNotSuggestedWhereUseless) {
    // Symmetry makes it 0.5.
    const Solution solution =
        solve(scene_named("drd_cubic_12")
                  .with("motion.symmetric = true", "motion.via = [{ at = 0.5, displacement = 0.4 }]"));
    ASSERT_EQ(solution.certificate.reason, "conditions_contradict");
    ASSERT_FALSE(solution.notes.empty());
    EXPECT_EQ(solution.notes[0].find("give it more segments"), std::string::npos) << solution.notes[0];
    EXPECT_FALSE(row_of(solution, "spline.segments"));
    const Solution scarce = solve(scene_named("three_points_on_four_segments"));
    EXPECT_NE(scarce.notes[0].find("give it more segments"), std::string::npos) << scarce.notes[0];
    EXPECT_TRUE(row_of(scarce, "spline.segments"));
}

TEST(JointRelaxation, IsTheLeastCommonPart) {
    const TestScene scene =  // the jerk has no need to give way
        scene_named("drd_cubic_12").with("limits = { velocity = 0.9, acceleration = 3, jerk = 400 }");
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.explanation);
    const std::vector<Relaxation>& together = solution.explanation->together;
    ASSERT_EQ(together.size(), 2U);
    const double part = *together[0].needed / 0.9 - 1.0;
    EXPECT_NEAR(*together[1].needed / 3.0 - 1.0, part, 1e-9);
    const auto relaxed = [&](double velocity, double acceleration) {
        return solve(scene.set("limits.velocity", velocity).set("limits.acceleration", acceleration));
    };
    const auto relaxed_by = [&](double how_far) {
        return relaxed(0.9 * (1.0 + how_far), 3.0 * (1.0 + how_far));
    };
    EXPECT_TRUE(relaxed_by(part * (1.0 + 1e-5)).motion);
    EXPECT_FALSE(relaxed_by(part * (1.0 - 1e-4)).motion);
    // As told.
    EXPECT_TRUE(relaxed(*together[0].solved, *together[1].solved).motion);
}

TEST(JointRelaxation, ScalesLowerLimitsEqually) {
    const Solution solution = solve(pressure_angle_scene(30, 12).with(
        "limits = { pressure_angle_deg = 15, concave_radius_min_mm = 300, velocity = 0.9 }",
        "solver.explain_seconds = 120"));
    ASSERT_TRUE(solution.explanation);
    std::map<std::string, double> factors;
    for (const Relaxation& row : solution.explanation->together)
        factors[row.key] =
            row.key == "limits.concave_radius_min_mm" ? row.given / *row.needed : *row.needed / row.given;
    ASSERT_EQ(factors.size(), 3U);
    const double common = factors["limits.pressure_angle_deg"];
    EXPECT_NEAR(factors["limits.concave_radius_min_mm"], common, 1e-9);
    EXPECT_GT(factors["limits.velocity"], 1.0);
    EXPECT_LT(factors["limits.velocity"], 0.9 * common) << "by no more than the others require";
}

TEST(Adjustment, LongerRiseUsesAngleOfReturn) {
    const auto most_of_rise = [](const Scene& scene) {
        const std::vector<Adjustment> all = adjustments(scene);
        return std::ranges::find(all, "motion.rise_deg", &Adjustment::key)->most;
    };
    Scene scene = pressure_angle_scene(12);
    scene.motion.type = MotionType::drd;
    EXPECT_NEAR(most_of_rise(scene), 360.0, 1e-9);
    scene.motion.type = MotionType::rr;
    scene.motion.return_angle.reset();
    EXPECT_NEAR(most_of_rise(scene), 180.0, 1e-9) << "the return is the rise mirrored";
    scene.motion.return_angle = 100.0 * units::degree;
    EXPECT_NEAR(most_of_rise(scene), 260.0, 1e-9);
}

TEST(Explanation, TimeoutLeavesUnsettledKeysAndReportsProgress) {
    Solution solution;
    solution.scene = pressure_angle_scene(24);
    solution.certificate.verdict = Verdict::infeasible;
    std::vector<std::string> told;
    SolveControl control;
    control.progress = [&](std::string_view message) { told.emplace_back(message); };
    control.deadline = Deadline::after(0.0);
    explain(solution, control);
    ASSERT_TRUE(solution.explanation);
    EXPECT_TRUE(solution.relaxation.empty()) << "what was not searched must not pass for hopeless";
    const std::vector<std::string>& unsettled = solution.explanation->unsettled;
    for (const char* key : {"limits.pressure_angle_deg", "motion.rise_deg", "cam.base_radius_mm"})
        EXPECT_TRUE(std::ranges::find(unsettled, key) != unsettled.end()) << key;
    ASSERT_FALSE(told.empty());
    EXPECT_NE(told[0].find("searching for changes, for at most 0 s"), std::string::npos) << told[0];
}

/// "Nothing helps" and "nobody looked to the end" must not be told by the same words.
TEST(Explanation, InterruptedCombinedSearchIsUnsettled) {
    Solution solution;
    solution.scene = scene_named("drd_cubic_12").with("limits = { velocity = 0.9, acceleration = 3 }");
    solution.certificate.verdict = Verdict::infeasible;
    bool stop = false;
    SolveControl control;
    control.progress = [&](const Progress& progress) {
        stop = stop || progress.message.find("all limits together") != std::string_view::npos;
    };
    control.stop_requested = [&] { return stop; };
    explain(solution, control);
    ASSERT_TRUE(stop);
    EXPECT_TRUE(solution.explanation->together.empty());
    const std::vector<std::string>& unsettled = solution.explanation->unsettled;
    EXPECT_EQ(std::ranges::count(unsettled, together_key), 1);
    ASSERT_EQ(solution.relaxation.size(), 2U);
    for (const Relaxation& row : solution.relaxation)  // of each alone all is known
        EXPECT_EQ(std::ranges::count(unsettled, row.key), 0) << row.key;
}

TEST(Explanation, TriesEveryCamAndSpringDimension) {
    const Scene scene = pressure_angle_scene(40).with(
        "motion.speed_rpm = 573", "limits.hertz_pressure_max_mpa = 500",
        "forces = { mass_kg = 0.8, spring_rate_n_mm = 4, preload_n = 20, contact_width_mm = 12 }");
    std::vector<std::string> keys;
    for (const Adjustment& one : adjustments(scene)) keys.push_back(one.key);
    for (const char* key :
         {"limits.pressure_angle_deg", "limits.hertz_pressure_max_mpa", "motion.rise_deg", "motion.speed_rpm",
          "forces.preload_n", "forces.spring_rate_n_mm", "forces.contact_width_mm", "cam.base_radius_mm",
          "cam.roller_radius_mm", "cam.offset_mm"})
        EXPECT_TRUE(std::ranges::find(keys, key) != keys.end()) << key;
}

// It starts with 1200 mm/s, above the limit, and with that limit raised needs a jerk of 215.4 m/s³.
TEST(Conflict, NamesEveryLimitImpossibleAlone) {
    const Solution solution = solve(
        scene_named("49_moving_start").with("limits.velocity_mm_s = 800", "solver.explain_seconds = 60"));
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    ASSERT_TRUE(solution.explanation);
    const std::vector<std::string>& alone = solution.explanation->alone;
    for (const char* const key : {"limits.velocity_mm_s", "limits.jerk_m_s3"})
        EXPECT_TRUE(std::ranges::find(alone, key) != alone.end()) << key;
    const std::vector<Relaxation>& together = solution.explanation->together;
    ASSERT_EQ(together.size(), 2U);
    EXPECT_EQ(together[1].key, "limits.jerk_m_s3");
    EXPECT_NEAR(*together[1].solved, 215.4, 0.1) << "the velocity limit does not take it along";
}

TEST(Conflict, IsTwoLimitsWhereTwoSuffice) {
    const Solution solution =
        solve(scene_named("drd_quintic_12").with("limits = { velocity = 1.5, acceleration = 5, jerk = 45 }"));
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_TRUE(solution.explanation->alone.empty());
    std::vector<std::string> keys;
    for (const ConflictReport& row : solution.conflict) keys.push_back(row.key);
    std::ranges::sort(keys);
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    EXPECT_EQ(keys.size(), 2U);
}

TEST(Conflict, OfFreeKnotsNamesLimits) {
    const Solution solution =
        solve(scene_named("drd_cubic_6")
                  .with("spline.knots = free", "limits = { velocity = 1.2, acceleration = 5 }"));
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_EQ(solution.conflict.size(), 2U);
}

TEST(Adjustment, StartOfMotionIsChanged) {
    const Solution solution =
        solve(scene_named("49_moving_start")
                  .with("limits.velocity_mm_s = 800", "limits.jerk_m_s3 = 2000",
                        "limits.acceleration_m_s2 = 400", "solver.explain_seconds = 60"));
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    const Relaxation* const row = row_of(solution, "motion.start.velocity_mm_s");
    ASSERT_TRUE(row && row->solved);
    EXPECT_LE(*row->solved, 800.0);
    EXPECT_GT(*row->solved, 790.0);
}

TEST(PrescribedMotion, IsShownWhereItViolatesLimit) {
    const Solution solution = solve(scene_named("43_laws"));
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    ASSERT_TRUE(solution.motion && solution.cam);
    ASSERT_EQ(solution.constraints.size(), 1U);
    // No offset has less than 24.01 deg.
    EXPECT_GE(solution.constraints[0].worst, 24.01);
    EXPECT_LE(solution.constraints[0].worst, 24.7);
}

}  // namespace relaxation_test
}  // namespace camopt
