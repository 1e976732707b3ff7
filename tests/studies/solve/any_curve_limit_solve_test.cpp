// SPDX-License-Identifier: MIT
// No spline solve ever goes below the limit that no curve can pass.
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"

#include <gtest/gtest.h>

#include <random>

namespace camopt {
namespace any_curve_limit_solve_test {

using testing_support::paper_objective;

TEST(AnyCurveLimitSolve, MatchesPublishedLimit) {
    const Solution solution = solve(paper_objective(MotionType::drd, 3, 12));
    ASSERT_TRUE(solution.any_curve_limit);
    EXPECT_NEAR(solution.any_curve_limit->objective, 0.9371963699, 1e-10);
    EXPECT_NEAR(*solution.any_curve_limit->velocity, 1.7455851, 1e-7);
    EXPECT_NEAR(*solution.any_curve_limit->acceleration, 5.2837114, 1e-7);
    EXPECT_NEAR(*solution.any_curve_limit->jerk, 54.609086, 1e-6);
}

TEST(AnyCurveLimitSolve, HoldsForRandomWeights) {
    std::mt19937 random(2026);
    std::uniform_real_distribution<double> weight(0.0, 1.0);
    std::uniform_int_distribution<int> segments(4, 20);
    int reached = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const MotionType type = trial % 3 == 2 ? MotionType::rr : MotionType::drd;
        const int degree = trial % 5 == 4 ? 5 : 3;
        Scene scene =
            paper_objective(type, degree, std::max(segments(random), type == MotionType::rr ? 8 : 4));
        const auto drawn = [&](int zero_at) { return trial % 7 == zero_at ? 0.0 : weight(random); };
        scene.objective.velocity = drawn(1);
        scene.objective.acceleration = drawn(2);
        scene.objective.jerk = drawn(3);
        if (type == MotionType::rr && trial % 2 == 0)
            scene.motion.return_angle = scene.motion.rise * (0.2 + 0.79 * weight(random));
        scene.objective.tie_break = TieBreak::none;
        scene.motion.within_lift = false;  // eight segments cannot always: the bound is the subject
        const Solution solution = solve(scene);
        ASSERT_EQ(solution.certificate.verdict, Verdict::optimal)
            << "trial " << trial << ' ' << solution.certificate.reason;
        ASSERT_TRUE(solution.any_curve_limit) << "trial " << trial;
        const double objective = solution.certificate.objective;
        EXPECT_GE(objective, solution.any_curve_limit->objective * (1.0 - 1e-11)) << "trial " << trial;
        if (objective < solution.any_curve_limit->objective * 1.05) ++reached;
    }
    EXPECT_GT(reached, 100);  // a limit far below every solve would prove nothing
}

TEST(AnyCurveLimitSolve, SevenSegmentsReachIt) {
    // τ = A/J, V/A, … : the switching points of the double-S for the paper's weights.
    const double velocity = 1.7455851, acceleration = 5.2837114, jerk = 54.609086;
    const double tau = acceleration / jerk;
    const double ramp = velocity / acceleration;
    Scene scene = paper_objective(MotionType::drd, 3, 7);
    scene.spline.breakpoints = {0.0, tau, ramp, ramp + tau, 1.0 - ramp - tau, 1.0 - ramp, 1.0 - tau, 1.0};
    const Solution solution = solve(scene);
    EXPECT_NEAR(solution.certificate.objective, 0.9371963699, 1e-8);
}

}  // namespace any_curve_limit_solve_test
}  // namespace camopt
