// SPDX-License-Identifier: MIT
// A picture before its proof: near the answer, by less work, and without a claim.
#include "studies/search/planned_solve.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace look_test {

using namespace testing_support;

/// Not convex: max |y' y''| weighs.
TestScene torque_scene(double velocity) {
    return scene_named("drd_cubic_12")
        .with("objective.torque = 0.5", "objective.reference = modified_sine")
        .set("objective.velocity", velocity);
}

Solution look(const Scene& scene, KnownSolutions& known) {
    return solve_without_explaining(scene, {}, &known, {.look = true});
}

TEST(LookTest, SearchContinuesFromLastMotion) {
    KnownSolutions known;
    const Solution first = solve_without_explaining(torque_scene(0.4), {}, &known);
    ASSERT_GE(first.solver.starts, 2);
    const Solution seen = look(torque_scene(0.42), known);
    EXPECT_EQ(seen.solver.starts, 1);
    EXPECT_FALSE(seen.certificate.lower_bound.has_value());
    EXPECT_NE(seen.certificate.verdict, Verdict::optimal);
    const Solution whole = solve(torque_scene(0.42));
    EXPECT_NEAR(seen.certificate.objective, whole.certificate.objective, 1e-6);
    EXPECT_LT(seen.solver.iterations, whole.solver.iterations);
}

TEST(LookTest, SolvesCompletelyWithoutLastMotion) {
    KnownSolutions known;
    const Solution seen = look(torque_scene(0.4), known);
    EXPECT_EQ(seen.solver.starts, default_starts);
    const Scene other = torque_scene(0.4).with("spline.segments = 14");
    EXPECT_EQ(look(other, known).solver.starts, default_starts) << "another spline is no neighbour";
}

TEST(LookTest, ConvexSceneIsSolvedAndTied) {
    KnownSolutions known;
    for (const double velocity : {0.4, 0.45}) {
        const Scene scene = scene_named("drd_cubic_16").set("objective.velocity", velocity);
        const Solution seen = look(scene, known);
        const Solution whole = solve(scene);
        EXPECT_EQ(seen.certificate.verdict, Verdict::optimal);
        EXPECT_NEAR(seen.certificate.objective, whole.certificate.objective, 1e-8);
        for (const double x : {0.2, 0.5, 0.8})
            EXPECT_NEAR(seen.motion->at(x, Side::right).derivative[2],
                        whole.motion->at(x, Side::right).derivative[2], 1e-3);
    }
}

TEST(LookTest, SolveAfterLookIsUnchanged) {
    KnownSolutions known;
    (void)solve_without_explaining(torque_scene(0.4), {}, &known);
    (void)look(torque_scene(0.41), known);
    const Solution after = solve_without_explaining(torque_scene(0.42), {}, &known);
    const Solution cold = solve(torque_scene(0.42));
    EXPECT_EQ(after.solver.starts, cold.solver.starts);
    EXPECT_EQ(after.certificate.verdict, cold.certificate.verdict);
    EXPECT_NEAR(after.certificate.objective, cold.certificate.objective, 1e-9);
}

}  // namespace look_test
}  // namespace camopt
