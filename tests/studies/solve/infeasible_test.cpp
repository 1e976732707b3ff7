// SPDX-License-Identifier: MIT
// Scenes built to be infeasible: proved so through every backend, and explained by what would help.
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace infeasible_test {

using namespace testing_support;

struct InfeasibleCase {
    const char* name;
    TestScene scene;
};

std::vector<InfeasibleCase> infeasible_cases() {
    const TestScene cubic = scene_named("drd_cubic_12"), quintic = scene_named("drd_quintic_12");
    return {
        {"a velocity below the mean", cubic.with("limits.velocity = 0.9")},
        {"an acceleration below 4", cubic.with("limits.acceleration = 3.9")},
        {"a jerk below 32", quintic.with("limits.jerk = 31")},
        {"velocity and acceleration together", cubic.with("limits = { velocity = 1.5, acceleration = 4.5 }")},
        {"all three together", quintic.with("limits = { velocity = 1.8, acceleration = 5.4, jerk = 45 }")},
        {"rise and return", cubic.with("motion.type = RR", "limits.acceleration = 3")},
        {"a set point that needs more speed",
         cubic.with("motion.via = [{ at = 0.1, displacement = 0.4 }]", "limits.velocity = 2")}};
}

class Infeasible : public testing::TestWithParam<std::string> {};

TEST_P(Infeasible, IsProved) {
    if (!is_available(GetParam())) GTEST_SKIP() << GetParam() << " is not part of this build";
    for (const InfeasibleCase& one : infeasible_cases()) {
        SCOPED_TRACE(one.name);
        const Solution solution =
            solve(one.scene.set("solver.name", GetParam()).with("solver.max_seconds = 5"));
        EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible) << solution.certificate.reason;
        EXPECT_FALSE(solution.curve);
        ASSERT_TRUE(solution.certificate.proof);
        EXPECT_GT(recomputed_bound(*solution.certificate.proof), 0.0);
        EXPECT_EQ(solution.certificate.proof->statement, "least_common_violation");
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, Infeasible,
                         testing::Values("auto", "structured", "ipopt", "nlopt.slsqp", "nlopt.cobyla"),
                         [](const auto& backend) {
                             std::string name = backend.param;
                             std::ranges::replace(name, '.', '_');
                             return name;
                         });

TEST(Relaxation, AppliedWithMarginMakesSceneFeasible) {
    int applied = 0;
    for (const InfeasibleCase& one : infeasible_cases()) {
        SCOPED_TRACE(one.name);
        const Solution solution = solve(one.scene);
        EXPECT_FALSE(solution.relaxation.empty());
        for (const Relaxation& relaxation : solution.relaxation) {
            if (!relaxation.needed || !relaxation.key.starts_with("limits.")) continue;
            const auto eased = [&](double spare) {
                return solve(one.scene.set(relaxation.key, *relaxation.needed * (1.0 + spare)));
            };
            EXPECT_GT(*relaxation.needed, relaxation.given);
            const Solution feasible = eased(1e-6);
            EXPECT_TRUE(feasible.curve) << name_of(feasible.certificate.verdict) << ' ' << relaxation.key
                                        << ' ' << feasible.certificate.reason;
            ++applied;
            // A millionth less than needed must not do, or it was not the least.
            EXPECT_EQ(eased(-1e-6).certificate.verdict, Verdict::infeasible) << relaxation.key;
        }
    }
    EXPECT_GE(applied, 8);
}

TEST(Relaxation, IsNullWhenOneLimitCannotHelp) {
    const Solution solution =
        solve(scene_named("drd_cubic_12").with("limits = { velocity = 0.9, acceleration = 3 }"));
    ASSERT_EQ(solution.relaxation.size(), 2u);
    EXPECT_FALSE(solution.relaxation[0].needed);
    EXPECT_FALSE(solution.relaxation[1].needed);
}

TEST(Infeasible, BackendOptionsDoNotAffectProof) {
    if (!is_available("ipopt")) GTEST_SKIP() << "ipopt is not part of this build";
    const TestScene scene = scene_named("drd_cubic_12")
                                .with("solver = { name = 'ipopt', options = { mu_strategy = 'monotone' } }");
    EXPECT_EQ(solve(scene.with("limits.velocity = 1.6")).certificate.verdict, Verdict::optimal);
    EXPECT_EQ(solve(scene.with("limits.velocity = 0.9")).certificate.verdict, Verdict::infeasible);
}

TEST(Contradiction, IsInfeasibleAndNamed) {
    const Solution solution = solve(scene_named("three_points_on_four_segments"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_EQ(solution.certificate.reason, "conditions_contradict");
    ASSERT_TRUE(solution.certificate.proof);
    EXPECT_EQ(solution.certificate.proof->statement, "conditions");
    EXPECT_GT(recomputed_bound(*solution.certificate.proof), 1e-3);
    ASSERT_FALSE(solution.notes.empty());
    EXPECT_NE(solution.notes[0].find("of set point "), std::string::npos) << solution.notes[0];
}

TEST(Contradiction, FixedConditionIsFoundByEveryForm) {
    // Two quintic segments leave one control point free, whose basis function is level in the middle: y'(0.5)
    // is 1.875 whatever it is.
    for (const DesignKind kind : {DesignKind::states, DesignKind::coefficients, DesignKind::ordinates}) {
        const TestScene scene = scene_named("drd_jerk_only")
                                    .with("spline = { degree = 5, segments = 2 }")
                                    .set("spline.design", name_of(kind));
        const Solution solution = solve(scene.with("motion.via = [{ at = 0.5, velocity = 1 }]"));
        EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible) << name_of(kind);
        EXPECT_EQ(solution.certificate.reason, "conditions_contradict") << name_of(kind);
        ASSERT_TRUE(solution.certificate.proof);
        EXPECT_GT(recomputed_bound(*solution.certificate.proof), 0.1);
        // What it is anyway.
        const Solution kept = solve(scene.with("motion.via = [{ at = 0.5, velocity = 1.875 }]"));
        EXPECT_EQ(kept.certificate.verdict, Verdict::optimal) << name_of(kind);
        ASSERT_TRUE(kept.curve);
        EXPECT_NEAR(kept.curve->derivative(0.5, 1), 1.875, 1e-12);
    }
}

TEST(Contradiction, RedundantSetPointsAreNamedAndHarmless) {
    const Solution solution =
        solve(scene_named("drd_cubic_12")
                  .with("motion.symmetric = true", "motion.via = [{ at = 0.5, displacement = 0.5 }]"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_EQ(solution.notes.size(), 1u);
    EXPECT_NE(solution.notes[0].find("displacement of set point 1 = "), std::string::npos)
        << solution.notes[0];
}

}  // namespace infeasible_test
}  // namespace camopt
