// SPDX-License-Identifier: MIT
// Scenes built to be infeasible: proved so through every backend, and explained by what would help.
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace infeasible_test {

using testing_support::is_available;
using testing_support::normalised_limit;
using testing_support::paper_objective;

struct InfeasibleCase {
    const char* name;
    Scene scene;
};

std::vector<InfeasibleCase> infeasible_cases() {
    std::vector<InfeasibleCase> cases;
    const auto add = [&](const char* name, int degree, MotionType type = MotionType::drd) -> Scene& {
        cases.push_back({name, paper_objective(type, degree, 12)});
        return cases.back().scene;
    };
    add("a velocity below the mean", 3).limits.velocity = normalised_limit("limits.velocity", 0.9);
    add("an acceleration below 4", 3).limits.acceleration = normalised_limit("limits.acceleration", 3.9);
    add("a jerk below 32", 5).limits.jerk = normalised_limit("limits.jerk", 31.0);
    Scene& pair = add("velocity and acceleration together", 3);
    pair.limits.velocity = normalised_limit("limits.velocity", 1.5);
    pair.limits.acceleration = normalised_limit("limits.acceleration", 4.5);
    Scene& three = add("all three together", 5);
    three.limits.velocity = normalised_limit("limits.velocity", 1.8);
    three.limits.acceleration = normalised_limit("limits.acceleration", 5.4);
    three.limits.jerk = normalised_limit("limits.jerk", 45.0);
    add("rise and return", 3, MotionType::rr).limits.acceleration =
        normalised_limit("limits.acceleration", 3.0);
    Scene& point = add("a set point that needs more speed", 3);
    point.motion.via = {{0.1, 0.4, {}, {}}};
    point.limits.velocity = normalised_limit("limits.velocity", 2.0);
    return cases;
}

class Infeasible : public testing::TestWithParam<std::string> {};

TEST_P(Infeasible, IsProved) {
    if (!is_available(GetParam())) GTEST_SKIP() << GetParam() << " is not part of this build";
    for (InfeasibleCase& one : infeasible_cases()) {
        SCOPED_TRACE(one.name);
        one.scene.solver.name = GetParam();
        one.scene.solver.max_seconds = 5.0;
        const Solution solution = solve(one.scene);
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
            Scene eased = one.scene;
            for (std::optional<PeakLimit>* limit :
                 {&eased.limits.velocity, &eased.limits.acceleration, &eased.limits.jerk}) {
                if (*limit && (*limit)->key == relaxation.key) {
                    **limit = normalised_limit(relaxation.key.c_str(), *relaxation.needed * (1.0 + 1e-6));
                }
            }
            EXPECT_GT(*relaxation.needed, relaxation.given);
            const Solution feasible = solve(eased);
            EXPECT_TRUE(feasible.curve) << name_of(feasible.certificate.verdict) << ' ' << relaxation.key
                                        << ' ' << feasible.certificate.reason;
            ++applied;
            // A millionth less than needed must not do, or it was not the least.
            for (std::optional<PeakLimit>* limit :
                 {&eased.limits.velocity, &eased.limits.acceleration, &eased.limits.jerk}) {
                if (*limit && (*limit)->key == relaxation.key) {
                    **limit = normalised_limit(relaxation.key.c_str(), *relaxation.needed * (1.0 - 1e-6));
                }
            }
            EXPECT_EQ(solve(eased).certificate.verdict, Verdict::infeasible) << relaxation.key;
        }
    }
    EXPECT_GE(applied, 8);
}

TEST(Relaxation, IsNullWhenOneLimitCannotHelp) {
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    scene.limits.velocity = normalised_limit("limits.velocity", 0.9);
    scene.limits.acceleration = normalised_limit("limits.acceleration", 3.0);
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.relaxation.size(), 2u);
    EXPECT_FALSE(solution.relaxation[0].needed);
    EXPECT_FALSE(solution.relaxation[1].needed);
}

TEST(Infeasible, BackendOptionsDoNotAffectProof) {
    if (!is_available("ipopt")) GTEST_SKIP() << "ipopt is not part of this build";
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    scene.limits.velocity = normalised_limit("limits.velocity", 1.6);
    scene.solver.name = "ipopt";
    scene.solver.options["mu_strategy"] = std::string("monotone");
    EXPECT_EQ(solve(scene).certificate.verdict, Verdict::optimal);
    scene.limits.velocity = normalised_limit("limits.velocity", 0.9);
    EXPECT_EQ(solve(scene).certificate.verdict, Verdict::infeasible);
}

TEST(Contradiction, IsInfeasibleAndNamed) {
    Scene scene = paper_objective(MotionType::drd, 3, 4);  // one number is free
    scene.motion.via = {{0.25, 0.1, {}, {}}, {0.5, 0.5, {}, {}}, {0.75, 0.95, {}, {}}};
    const Solution solution = solve(scene);
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
        Scene scene;
        scene.spline.degree = 5;
        scene.spline.segments = 2;
        scene.spline.design = kind;
        scene.objective.jerk = 1.0;
        scene.motion.via = {{0.5, {}, 1.0, {}}};
        const Solution solution = solve(scene);
        EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible) << name_of(kind);
        EXPECT_EQ(solution.certificate.reason, "conditions_contradict") << name_of(kind);
        ASSERT_TRUE(solution.certificate.proof);
        EXPECT_GT(recomputed_bound(*solution.certificate.proof), 0.1);
        scene.motion.via = {{0.5, {}, 1.875, {}}};  // what it is anyway
        const Solution kept = solve(scene);
        EXPECT_EQ(kept.certificate.verdict, Verdict::optimal) << name_of(kind);
        ASSERT_TRUE(kept.curve);
        EXPECT_NEAR(kept.curve->derivative(0.5, 1), 1.875, 1e-12);
    }
}

TEST(Contradiction, RedundantSetPointsAreNamedAndHarmless) {
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    scene.motion.symmetric = true;
    scene.motion.via = {{0.5, 0.5, {}, {}}};
    const Solution solution = solve(scene);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_EQ(solution.notes.size(), 1u);
    EXPECT_NE(solution.notes[0].find("displacement of set point 1 = "), std::string::npos)
        << solution.notes[0];
}

}  // namespace infeasible_test
}  // namespace camopt
