// SPDX-License-Identifier: MIT
// The plan of a scene says, without a solve, what is searched, by whom, from where and with which proof; what
// was solved agrees with it.
#include "studies/search/plan.hpp"

#include "core/errors.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace camopt {
namespace plan_test {

using namespace testing_support;

/// Two strokes whose angles have ranges.
Scene two_angles() {
    Scene scene = program({dwell(100), spline(120, 1.0), dwell(20), spline(120, 0.0)});
    scene.motion.lift = 40e-3;
    for (const std::size_t k : {1u, 3u})
        scene.motion.segments[k].angle_range = AngleRange{90 * units::degree, 150 * units::degree};
    return scene;
}

/// The plan of what was solved is that of its scene.
void expect_executed(const SolvePlan& planned, const Solution& solution) {
    ASSERT_TRUE(solution.plan);
    EXPECT_EQ(solution.plan->solver, planned.solver);
    EXPECT_EQ(solution.plan->proof, planned.proof);
    EXPECT_EQ(solution.solver.convex, planned.convex);
    EXPECT_LE(solution.solver.starts, planned.starts);
    EXPECT_EQ(solution.design.kind, planned.design);
    const std::string& name = solution.solver.name;
    EXPECT_TRUE(name == planned.solver || name == planned.next_solver ||
                (name == "structured" && solution.solver.starts == 0))
        << name;
}

TEST(Plan, ConvexSceneIsProvedByDuality) {
    const Scene scene = paper_objective(MotionType::drd, 3, 12);
    const SolvePlan planned = plan(scene);
    EXPECT_EQ(planned.solver, "structured");
    EXPECT_FALSE(planned.reason.empty());
    EXPECT_EQ(planned.design, DesignKind::states);
    EXPECT_TRUE(planned.convex);
    EXPECT_EQ(planned.starts, 1);
    EXPECT_TRUE(planned.relaxations.empty());
    EXPECT_TRUE(planned.tie_break);
    EXPECT_EQ(planned.proof, ProofKind::duality);
    EXPECT_EQ(planned.cost_scale, 1.0);
    EXPECT_EQ(planned.next_solver, is_available("ipopt") ? "ipopt" : "");
    expect_executed(planned, solve(scene));
}

TEST(Plan, NamedSolverKeepsItsDesign) {
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    scene.solver.name = "nlopt.slsqp";
    scene.objective.tie_break = TieBreak::none;
    const SolvePlan planned = plan(scene);
    EXPECT_EQ(planned.solver, "nlopt.slsqp");
    EXPECT_TRUE(planned.reason.empty());
    EXPECT_TRUE(planned.next_solver.empty());
    EXPECT_EQ(planned.design, DesignKind::coefficients);
    EXPECT_FALSE(planned.tie_break);
}

TEST(Plan, NonConvexCamIsSearchedFromStarts) {
    const Scene scene = scene_named("cam_undercut");
    const SolvePlan planned = plan(scene);
    EXPECT_FALSE(planned.convex);
    EXPECT_EQ(planned.solver, "structured");
    EXPECT_EQ(planned.starts, scene.solver.starts.value_or(default_starts));
    EXPECT_FALSE(planned.relaxations.empty());
    EXPECT_EQ(planned.proof, ProofKind::boxes);
    EXPECT_EQ(planned.next_solver, is_available("ipopt") ? "ipopt" : "");
    EXPECT_EQ(plan(scene, {.look = true}).proof, ProofKind::none);
    expect_executed(planned, solve(scene));
}

TEST(Plan, StartsBeginWithWhatIsKnown) {
    using Kinds = std::vector<StartKind>;
    const auto kinds = [](bool measured) {
        Kinds all;
        for (int k = 0; k < 4; ++k) all.push_back(start_kind(measured, k));
        return all;
    };
    EXPECT_EQ(kinds(false),
              (Kinds{StartKind::relaxation, StartKind::smoothest, StartKind::random, StartKind::random}));
    EXPECT_EQ(kinds(true),
              (Kinds{StartKind::measured, StartKind::relaxation, StartKind::smoothest, StartKind::random}));
}

TEST(Plan, FreeKnotsAreSearched) {
    const SolvePlan planned = plan(scene_named("drd_free_knots"));
    EXPECT_GT(planned.breakpoints, 0);
    EXPECT_FALSE(planned.convex);
    EXPECT_GT(planned.starts, 1);
    EXPECT_EQ(planned.proof, ProofKind::any_curve_limit);
    EXPECT_EQ(planned.solver, "structured") << "for given breakpoints the scene is convex";
}

TEST(Plan, FreeAnglesAreBoundedIfMonotone) {
    Scene scene = two_angles();
    const SolvePlan planned = plan(scene);
    EXPECT_EQ(planned.angles, 2);
    EXPECT_FALSE(planned.convex);
    EXPECT_EQ(planned.starts, 1);
    EXPECT_EQ(planned.proof, ProofKind::boxes);
    expect_executed(planned, solve(scene));
    scene.objective.rms_jerk = 1.0;  // a mean over the turn weighs segments by their angles
    scene.objective.reference.rms_jerk = 20.0;
    EXPECT_EQ(plan(scene).proof, ProofKind::none);
    EXPECT_FALSE(plan(scene).tie_break);
}

TEST(Plan, StrokesAreHeldOnlyIfNeeded) {
    Scene scene = paper_objective(MotionType::rr, 3, 12);
    EXPECT_TRUE(plan(scene).strokes_first_free);
    expect_executed(plan(scene), solve(scene));
    scene.motion.within_lift = false;
    EXPECT_FALSE(plan(scene).strokes_first_free);
}

TEST(Plan, CostFarFromOneIsScaled) {
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    EXPECT_EQ(plan(scene).cost_scale, 1.0);
    scene.objective.velocity = scene.objective.acceleration = scene.objective.jerk = 1e-6;
    EXPECT_EQ(plan(scene).cost_scale, std::exp2(-18.0)) << "a power of two near 3e-6";
}

TEST(Plan, ExplanationFollowsOnRequest) {
    const Scene scene = paper_objective(MotionType::drd, 3, 12);
    EXPECT_EQ(plan(scene).explain_seconds, 0.0);
    EXPECT_EQ(plan(scene, {.explain = true}).explain_seconds, scene.solver.explain_seconds);
    EXPECT_LT(plan(scene, {.explain = true}).searching, 1.0);
}

TEST(Plan, WrongSceneIsRefused) {
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    scene.spline.segments = -1;
    EXPECT_THROW(static_cast<void>(plan(scene)), InputError);
}

}  // namespace plan_test
}  // namespace camopt
