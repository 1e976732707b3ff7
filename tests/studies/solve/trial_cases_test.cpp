// SPDX-License-Identifier: MIT
// Scenes of tests/cases that earlier versions answered wrongly, with answers from independent programs.
#include "studies/delivered/driven_mechanism.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/solved_scene.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace camopt {
namespace trial_cases_test {

using namespace testing_support;

struct Answer {
    const char* scene;
    double objective, tolerance;
};

void PrintTo(const Answer& answer, std::ostream* stream) {
    *stream << answer.scene;
}

class TrialCases : public testing::TestWithParam<Answer> {};

TEST_P(TrialCases, HaveTheRightOptimum) {
    const Solution& solution = solved(scene_named(GetParam().scene));
    const Certificate& certificate = solution.certificate;
    ASSERT_EQ(certificate.verdict, Verdict::optimal) << name_of(certificate.reason);
    EXPECT_NEAR(certificate.objective, GetParam().objective, GetParam().tolerance);
    EXPECT_LE(*certificate.lower_bound, certificate.objective + 1e-9);
    EXPECT_GE(*certificate.lower_bound, certificate.objective - 1e-4 * std::max(1.0, certificate.objective));
}

// The last digits of a weight decide whether the first attempts of the structured solver end: another one
// does.
TEST(TrialCase, IsProvedWithNeighbouringWeights) {
    for (int i = 1; i <= 6; ++i) {
        const Solution solution = solve(
            scene_named("area_below_zero_false_optimal")
                .with("solver.name = \"structured\"", fmt::format("objective.jerk = 0.001000000000{}", i)));
        EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << i;
        EXPECT_NEAR(solution.certificate.objective, -0.42259666, 2e-7) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Area, TrialCases,
                         testing::Values(Answer{"area_below_zero_false_optimal", -0.42259666, 2e-7},
                                         Answer{"area_below_zero_same_with_lift_20", 1.57740335, 2e-7}));
// y' = 0 at a reversal next to a stroke with a set point: 0.734782128 without.
INSTANTIATE_TEST_SUITE_P(Reversal, TrialCases,
                         testing::Values(Answer{"turning_point_with_via", 0.73506731, 2e-8}));

TEST(TrialCases, AreaMayNotDecreaseWithoutBound) {
    const Solution solution = solve(scene_named("area_rr_unbounded_false_optimal"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
    EXPECT_EQ(solution.certificate.reason, Reason::unbounded) << name_of(solution.certificate.reason);
    EXPECT_FALSE(solution.certificate.lower_bound);
}

TEST(TrialCases, AreaIsThatOfTheMotion) {
    const Solution& solution = solved(scene_named("area_below_zero_false_optimal"));
    // From the delivered motion alone: 1 − its mean, by the midpoint rule on fine steps.
    constexpr int steps = 200000;
    const MotionChain& motion = *solution.motion;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
        sum += motion.at(motion.begin() + (motion.end() - motion.begin()) * (i + 0.5) / steps).derivative[0];
    const double jerk = solution.peaks.jerk.value;
    EXPECT_NEAR((1.0 - sum / steps) / 0.5 + 0.001 * jerk / 69.0, solution.certificate.objective, 1e-8);
}

TEST(TrialCases, RepeatedSplinesJoin) {
    const Solution& solution = solved(scene_named("repeat_refused_breakpoints"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_EQ(solution.segments.size(), solution.scene.motion.segments.size());
}

TEST(TrialCases, SetPointAtLimitIsProved) {
    EXPECT_EQ(solve(scene_named("set_point_at_the_limit")).certificate.verdict, Verdict::optimal);
}

TEST(TrialCases, VerdictsOfOneMotionAgree) {
    const Solution solution = solve(scene_named("contradicting_verdicts")
                                        .with("limits = { velocity = 2.053130027444412 }",
                                              "objective = { jerk = 1 }", "solver.max_seconds = 60"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_GE(solution.peaks.jerk.value, 38.696);
}

/// The largest Hertz pressure of the delivered cam at a speed of the cam, Pa, on a fine grid.
double hertz_at(const Solution& solution, double speed) {
    const Scene& scene = solution.scene;
    const MotionScale scale{scene.motion.lift, scene.motion.unit_angle()};
    double largest = 0.0;
    constexpr int steps = 7200;
    for (int i = 0; i < steps; ++i) {
        const double x = solution.motion->end() * i / steps;
        const MotionPoint point = solution.motion->at(x);
        const FollowerState state = state_of(point, scale);
        const double force = scene.forces->force(speed, state, scale.unit_angle * x);
        const double radius = 0.017 + state.s + state.acceleration;  // of a flat follower
        const double modulus = 2.0 * (1.0 - 0.3 * 0.3) / 210e9;
        largest = std::max(largest,
                           std::sqrt(std::max(0.0, force) / (modulus * std::numbers::pi * 0.013 * radius)));
    }
    return largest;
}

TEST(TrialCases, HertzPressureHoldsFromRest) {
    Scene scene = scene_named("hertz_at_speed");
    const double speed = *scene.motion.speed;
    // At this speed alone the lobe has 568 MPa, and 932 MPa near rest.
    scene.forces->speed_range = {speed, speed};
    const Solution one = solve(scene);
    ASSERT_EQ(one.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(hertz_at(one, speed) / 1e6, 568.0, 1.0);
    EXPECT_GT(hertz_at(one, 0.0) / 1e6, 900.0);
    scene.forces->speed_range.reset();
    const Solution all = solve(scene);
    ASSERT_EQ(all.certificate.verdict, Verdict::optimal);
    for (const double part : {0.0, 0.1, 0.5, 0.9, 1.0})
        EXPECT_LE(hertz_at(all, part * speed) / 1e6, 700.0 * (1.0 + 1e-7)) << part;
}

}  // namespace trial_cases_test
}  // namespace camopt
