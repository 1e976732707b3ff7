// SPDX-License-Identifier: MIT
// What a user is told to change comes in time, in the order of its usefulness, and does make the scene
// feasible: every change is written into the scene file as it is printed, and the file is solved.
#include "report/solve/infeasible_words.hpp"
#include "report/view/key_words.hpp"
#include "studies/least/adjustment.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace camopt {
namespace useful_changes_test {

using namespace testing_support;

struct Case {
    std::string name;
    TestScene scene;
    friend void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }
};

/// The scene file with the change, as a user would write it.
TestScene with_change(const TestScene& scene, const Relaxation& row) {
    TestScene changed = scene.set(row.key, *row.solved);
    for (const CompanionChange& other : row.also) changed = changed.set(other.key, other.solved);
    return changed;
}

std::string told(const Solution& solution) {
    std::string text;
    for (const std::string& remark : infeasible_remarks(solution)) text += remark + "\n";
    return text;
}

const TestScene servo = scene_named("servo_four_moves"), lobe = scene_named("lobe_ramp_set_point"),
                infeasible_cam = scene_named("cam_infeasible");

class UsefulChanges : public testing::TestWithParam<Case> {};

TEST_P(UsefulChanges, AreFoundInTimeAndSuffice) {
    const Solution solution = solve(GetParam().scene);
    ASSERT_FALSE(solution.motion);
    ASSERT_TRUE(solution.explanation);
    EXPECT_LE(solution.explanation->allowed, 5.0);
    ASSERT_FALSE(solution.relaxation.empty());
    ASSERT_TRUE(solution.relaxation.front().solved) << told(solution);
    int applied = 0;
    for (const Relaxation& row : solution.relaxation) {
        if (!row.solved || applied == 2) continue;
        ++applied;
        const TestScene changed = with_change(GetParam().scene, row).with("solver.explain_seconds = 0");
        EXPECT_TRUE(solve(changed).motion) << change_words(row);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Infeasible, UsefulChanges,
    testing::Values(
        Case{"servo", servo}, Case{"lobe", lobe}, Case{"far_target", scene_named("far_target")},
        Case{"spring", scene_named("spring_float").with("spline.segments = 64", "forces.preload_n = 2")},
        Case{"cam", infeasible_cam},
        Case{"cam_not_convex", infeasible_cam.with("limits.cam_radius_min_mm = 8", "spline.segments = 64")},
        Case{"undercut",
             scene_named("cam_undercut").with("limits.cam_radius_min_mm = 30", "spline.segments = 64")},
        Case{"cap", scene_named("infeasible_velocity_cap")}),
    [](const auto& one) { return one.param.name; });

TEST(UsefulChange, ServoProgramChangesAngleAndDwell) {
    const Solution solution = solve(servo.with("solver.explain_seconds = 60"));
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    const Relaxation& first = solution.relaxation.front();
    EXPECT_EQ(first.key, "motion.segments[2].angle_deg");
    EXPECT_EQ(first.given, 50.0);
    ASSERT_TRUE(first.solved);
    EXPECT_NEAR(*first.solved, 54.1, 0.1);
    ASSERT_EQ(first.also.size(), 1U);
    EXPECT_EQ(first.also[0].key, "motion.segments[3].angle_deg");
    EXPECT_NEAR(*first.solved + first.also[0].solved, 90.0, 1e-12);
    EXPECT_TRUE(says(told(solution),
                     "lengthen the angle of segment 3 (motion.segments[2].angle_deg) from 50 to 54."));
    EXPECT_TRUE(says(told(solution),
                     "taken from the angle of segment 4 (motion.segments[3].angle_deg), which becomes 35."));
    EXPECT_TRUE(says(told(solution), "raise the acceleration limit to 66"));
}

/// Free breakpoints leave what no curve can do: the least rise is that of the quickest jerk-limited motion,
/// in closed form where it has a cruise, and where its velocity is not reached.
TEST(UsefulChange, FreeKnotsNeedLeastRise) {
    constexpr double lift = 0.03, acceleration = 25.0, jerk = 3125.0, deg_s = 1200.0;
    const double peak = 0.5 * acceleration *
                        (std::sqrt(acceleration * acceleration / (jerk * jerk) + 4.0 * lift / acceleration) -
                         acceleration / jerk);
    for (const double velocity_mm_s : {771.0, 772.0}) {
        const double velocity = std::min(peak, 1e-3 * velocity_mm_s);
        const double least = deg_s * (lift / velocity + velocity / acceleration + acceleration / jerk);
        const Solution solution =
            solve(scene_named("jerk_limited_rise").set("limits.velocity_mm_s", velocity_mm_s));
        EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
        EXPECT_EQ(solution.certificate.proof_kind, ProofKind::any_curve_limit);
        ASSERT_FALSE(solution.relaxation.empty());
        const Relaxation& row = solution.relaxation.front();
        EXPECT_EQ(row.key, "motion.rise_deg");
        ASSERT_TRUE(row.needed && row.solved);
        EXPECT_NEAR(*row.needed, least, 1e-5);
        EXPECT_NEAR(*row.solved, least, 2e-3);
    }
}

TEST(UsefulChange, UsesNextDwellBeforePreviousOne) {
    const std::vector<Adjustment> all = motion_adjustments(servo);
    std::vector<std::string> givers;
    for (const Adjustment& one : all)
        if (one.key == "motion.segments[2].angle_deg")
            givers.push_back(one.also(one.given + 1.0).front().key);
    EXPECT_EQ(givers,
              (std::vector<std::string>{"motion.segments[3].angle_deg", "motion.segments[1].angle_deg"}));
}

TEST(UsefulChange, NamesSetPointContradictedByRamp) {
    const Solution& solution = solved(lobe);
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    ASSERT_TRUE(solution.explanation);
    const std::vector<std::string>& named = solution.explanation->set_points;
    EXPECT_EQ(std::ranges::count(named, "motion.via[1]"), 1);
    const auto row = std::ranges::find_if(
        solution.relaxation, [](const Relaxation& one) { return one.key.starts_with("motion.via[1]."); });
    ASSERT_NE(row, solution.relaxation.end()) << told(solution);
    EXPECT_TRUE(row->solved);
    EXPECT_TRUE(says(told(solution), "displacement of set point 2 = 0.35 mm at 25 deg (motion.via[1])"));
}

/// Other conditions leave one value: 0.5 mm and 10 deg of 0.012 mm/deg.
TEST(UsefulChange, DeterminedSetPointIsItsValue) {
    const TestScene inside = lobe.with("motion.via[0].from_deg = 20", "motion.via[0].to_deg = 40",
                                       "motion.via[0].displacement_mm = 0.5", "motion.via[1].at_deg = 30",
                                       "limits.acceleration_mm_s2 = 6000000", "solver.explain_seconds = 60");
    const Solution solution = solve(inside);
    ASSERT_EQ(solution.certificate.reason, Reason::conditions_contradict);
    const auto row =
        std::ranges::find(solution.relaxation, "motion.via[1].displacement_mm", &Relaxation::key);
    ASSERT_NE(row, solution.relaxation.end()) << told(solution);
    EXPECT_NEAR(*row->solved, 0.5 + 10.0 * 0.012, 1e-9);
    EXPECT_TRUE(solve(with_change(inside, *row)).motion);
}

TEST(UsefulChange, StopsAfterEnoughAreFound) {
    const TestScene scene = infeasible_cam.with("spline.segments = 8");
    const Solution three = solve(scene);
    ASSERT_EQ(three.relaxation.size(), 3U);
    EXPECT_EQ(three.relaxation[0].key, "motion.rise_deg");
    EXPECT_EQ(three.relaxation[1].key, "cam.base_radius_mm");
    EXPECT_EQ(three.relaxation[2].key, "limits.pressure_angle_deg");
    EXPECT_EQ(three.explanation->end, ExplanationEnd::enough);
    EXPECT_EQ(solve(scene.with("solver.explain_changes = 1")).relaxation.size(), 1U);
    EXPECT_GT(solve(scene.with("solver.explain_changes = 100")).relaxation.size(), 3U);
}

/// A lift written in mm keeps the displacements that are written in mm.
TEST(UsefulChange, LiftChangeScalesOnlyLiftUnits) {
    Scene scene = servo;
    const auto keys = [&] {
        std::vector<std::string> all;
        for (const Adjustment& one : motion_adjustments(scene)) all.push_back(one.key);
        return all;
    };
    const auto has = [](const std::vector<std::string>& all, const char* key) {
        return std::ranges::find(all, key) != all.end();
    };
    EXPECT_FALSE(has(keys(), "motion.lift_mm")) << "every displacement is in mm";
    EXPECT_TRUE(has(keys(), "motion.segments[2].to_mm"));
    EXPECT_FALSE(has(keys(), "motion.segments[6].to_mm")) << "the turn ends at 0";
    scene.motion.segments[2].to_unit.clear();
    ASSERT_TRUE(has(keys(), "motion.lift_mm"));
    const std::vector<Adjustment> all = motion_adjustments(scene);
    const Scene less = std::ranges::find(all, "motion.lift_mm", &Adjustment::key)->with(scene, 48.0);
    EXPECT_NEAR(*less.motion.segments[0].to * less.motion.lift, 0.030, 1e-15);
    EXPECT_NEAR(*less.motion.segments[2].to * less.motion.lift, 0.048, 1e-15);
}

TEST(ExplanationTime, InterruptionIsNotReportedAsTimeout) {
    bool stop = false;
    SolveControl control;
    control.progress = [&](const Progress& progress) {
        stop = stop || progress.message.find("suggested changes: limits.") != std::string_view::npos;
    };
    control.stop_requested = [&] { return stop; };
    const Solution solution =
        solve(infeasible_cam.with("spline.segments = 8", "solver.explain_changes = 100"), control);
    ASSERT_TRUE(stop);
    for (const std::string& note : solution.notes) EXPECT_FALSE(says(note, "max_seconds"));
    EXPECT_EQ(solution.explanation->end, ExplanationEnd::interrupted);
    EXPECT_TRUE(says(told(solution), "The search for changes was interrupted after"));
    EXPECT_FALSE(says(told(solution), "max_seconds"));
}

TEST(ExplanationTime, FiveSecondLimitIsReported) {
    double now = 0.0;
    SolveControl control;
    control.deadline = Deadline::after(1e9, [&] { return now; });
    control.progress = [&](const Progress& progress) {
        if (progress.message.find("suggested changes: limits.") != std::string_view::npos) now += 6.0;
    };
    const Solution solution =
        solve(infeasible_cam.with("spline.segments = 8", "solver.explain_changes = 100"), control);
    EXPECT_EQ(solution.explanation->end, ExplanationEnd::time_limit);
    EXPECT_TRUE(solution.relaxation.front().solved) << "found before";
    EXPECT_TRUE(says(told(solution), "(solver.explain_seconds)"));
    for (const std::string& note : solution.notes) EXPECT_FALSE(says(note, "max_seconds"));
}

}  // namespace useful_changes_test
}  // namespace camopt
