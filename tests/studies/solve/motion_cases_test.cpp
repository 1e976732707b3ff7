// SPDX-License-Identifier: MIT
// What must hold beside the answers of trial_cases_test.cpp: areas that nothing or only a limit bounds, the
// seam of a relative motion, a repeated part written out.
#include "tests/support/refusal.hpp"
#include "tests/support/solved_scene.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace camopt {
namespace motion_cases_test {

using namespace testing_support;

void expect_optimum(const Solution& solution, double objective, double within) {
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    EXPECT_NEAR(solution.certificate.objective, objective, within);
}

TEST(MotionCases, UnboundedAreaIsSaid) {
    const Solution& solution = solved(scene_named("area_rr_unbounded_false_optimal"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
    EXPECT_EQ(solution.certificate.reason, Reason::unbounded);
    EXPECT_FALSE(solution.certificate.lower_bound.has_value());
    ASSERT_FALSE(solution.notes.empty());
    EXPECT_NE(solution.notes.back().find("no least value"), std::string::npos) << solution.notes.back();
}

TEST(MotionCases, LimitsBoundTheAreaWithoutStrokes) {
    const Solution solution =
        solve(scene_named("area_rr_unbounded_false_optimal").with("limits.velocity = 2"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    ASSERT_NE(solution.motion, nullptr);
}

TEST(MotionCases, ObjectiveIsThatOfTheCurve) {
    const Solution solution = solve(scene_named("objective_not_of_the_curve"));
    EXPECT_NE(solution.certificate.verdict, Verdict::failed) << solution.certificate.reason;
    ASSERT_NE(solution.motion, nullptr);
    EXPECT_LT(solution.certificate.objective, 0.0);
}

TEST(MotionCases, SeamOfRelativeMotionTurns) {
    const std::string text =
        "[motion]\ntype = \"program\"\nlift_mm = 10\nclosed = \"relative\"\nsegments = [\n"
        "{ kind = \"spline\", angle_deg = 151, to = 1.29 }, { kind = \"spline\", angle_deg = 209, to = 0.25 "
        "}]\n"
        "[spline]\ndegree = 5\nsegments = 9\n[objective]\njerk = 1\n";
    const Solution solution = solve(TestScene(text));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    ASSERT_NE(solution.motion, nullptr);
    EXPECT_NEAR(solution.motion->at(0.0, Side::right).derivative[1], 0.0, 1e-12);
}

TEST(MotionCases, LawAboveStrokesCountsInArea) {
    const auto text = [](double lift, double scale, double weight) {
        return fmt::format(
            "[motion]\ntype = \"program\"\nlift_mm = {}\nclosed = false\nsegments = [\n"
            "{{ kind = \"spline\", angle_deg = 100, to = {} }}, {{ kind = \"law\", law = "
            "\"polynomial_345\", angle_deg = 200, to = {} }}]\n[spline]\nsegments = 9\n[objective]\n"
            "area = {}\njerk = 0.1\nreference = {{ area = 0.5, jerk = 69 }}\n",
            lift, 1.0 * scale, 3.0 * scale, weight);
    };
    const Solution low = solve(TestScene(text(10, 1.0, 1.0))), high = solve(TestScene(text(40, 0.25, 4.0)));
    EXPECT_LT(low.certificate.objective, 0.0);
    // 4 (1 − m / 4) = (1 − m) + 3, divided by the reference 0.5.
    expect_optimum(low, high.certificate.objective - 6.0, 1e-6);
    ASSERT_TRUE(low.certificate.lower_bound && high.certificate.lower_bound);
    EXPECT_LE(*low.certificate.lower_bound, low.certificate.objective);
    EXPECT_LE(*low.certificate.lower_bound, high.certificate.objective - 6.0 + 1e-6);
    EXPECT_GE(*low.certificate.lower_bound, low.certificate.objective - 1e-6);
}

TEST(MotionCases, RepeatedSplinesJoin) {
    const Solution& solution = solved(scene_named("repeat_refused_breakpoints"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    Scene whole = solution.scene;  // written out: by convexity its optimum has the symmetry too
    whole.motion.repeat = 1;
    for (const std::size_t end_of_part : {2U, 5U}) whole.motion.segments[end_of_part].to = 0.0;
    expect_optimum(solve(whole), solution.certificate.objective, 1e-6);
}

TEST(MotionCases, StopsMustBeTheStrokes) {
    const std::string message = refusal([] { (void)scene_named("stops_and_to").read(); });
    EXPECT_NE(message.find("stops_and_to.toml:5:1: motion.stops: found 8 stops"), std::string::npos)
        << message;
}

}  // namespace motion_cases_test
}  // namespace camopt
