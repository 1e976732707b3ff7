// SPDX-License-Identifier: MIT
// Time limits, iteration limits and Ctrl-C: the best feasible point so far is kept and labelled.
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace stopping_test {

using namespace testing_support;

class Stopping : public testing::TestWithParam<std::string> {
 protected:
    void SetUp() override {
        if (!is_available(GetParam())) GTEST_SKIP() << GetParam() << " is not part of this build";
    }
    [[nodiscard]] static TestScene scene() {
        return scene_named("drd_quintic_12").with("spline.segments = 24").set("solver.name", GetParam());
    }
};

TEST_P(Stopping, AStopRequestDeliversAFeasibleCurve) {
    SolveControl control;
    int polls = 0;
    control.stop_requested = [&] { return ++polls > 3; };
    const Solution solution = solve(scene(), control);
    EXPECT_EQ(solution.certificate.verdict, Verdict::feasible);
    EXPECT_EQ(solution.certificate.reason, "interrupted");
    ASSERT_TRUE(solution.curve);
    EXPECT_NEAR(solution.curve->at(1.0).derivative[0], 1.0, 1e-9);
}

TEST_P(Stopping, ATimeLimitDeliversAFeasibleCurve) {
    const Solution solution = solve(scene().with("solver.max_seconds = 1e-6"));
    EXPECT_EQ(solution.certificate.reason, "time_limit");
    EXPECT_EQ(solution.certificate.verdict, Verdict::feasible);
    ASSERT_TRUE(solution.curve);
}

TEST_P(Stopping, StopWithoutFeasiblePointIsReported) {
    SolveControl control;
    control.stop_requested = [] { return true; };
    const Solution solution = solve(scene().with("limits.velocity = 1.3"), control);
    EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
    EXPECT_EQ(solution.certificate.reason, "interrupted");
    EXPECT_FALSE(solution.curve);
}

TEST_P(Stopping, EarlyStopDeliversNoMotion) {
    SolveControl control;
    control.stop_requested = [] { return true; };
    const Solution solution = solve(scene(), control);  // its start satisfies every limit
    EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
    EXPECT_EQ(solution.certificate.reason, "interrupted");
    EXPECT_FALSE(solution.motion);
    EXPECT_TRUE(solution.constraints.empty());
}

/// Of a cam whose limits are not convex: several starts.
TestScene searched_scene() {
    return scene_named("drd_quintic_12")
        .with("motion.lift_mm = 20", "motion.rise_rad = 1.6", "spline.segments = 16",
              "cam = { type = 'disk', follower = 'translating_roller', base_radius_mm = 30, roller_radius_mm "
              "= 10 }",
              "limits = { cam_radius_min_mm = 12, concave_radius_min_mm = 50 }");
}

TEST(StoppingASearch, ImmediatelyDeliversNoMotion) {
    for (const bool free_knots : {false, true}) {
        const TestScene scene =
            free_knots ? scene_named("drd_cubic_6").with("spline.knots = free") : searched_scene();
        SolveControl control;
        control.stop_requested = [] { return true; };
        const Solution solution = solve(scene, control);
        EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
        EXPECT_EQ(solution.certificate.reason, "interrupted");
        EXPECT_FALSE(solution.motion);
    }
}

TEST(StoppingASearch, AnyPollEndsConsistently) {
    for (const int patience : {1, 10, 40, 160}) {
        SolveControl control;
        int polls = 0;
        control.stop_requested = [&] { return ++polls > patience; };
        const Solution solution = solve(searched_scene(), control);
        const Certificate& certificate = solution.certificate;
        if (polls <= patience) break;  // it ended before
        if (certificate.verdict == Verdict::failed) {
            EXPECT_EQ(certificate.reason, "interrupted") << patience;
            EXPECT_FALSE(solution.motion);
        } else {
            EXPECT_LE(certificate.worst_violation, 1e-9) << patience;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, Stopping,
                         testing::Values("structured", "ipopt", "nlopt.slsqp", "nlopt.cobyla"),
                         [](const auto& backend) {
                             std::string name = backend.param;
                             std::ranges::replace(name, '.', '_');
                             return name;
                         });

}  // namespace stopping_test
}  // namespace camopt
