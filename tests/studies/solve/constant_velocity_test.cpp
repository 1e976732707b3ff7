// SPDX-License-Identifier: MIT
// The law of constant velocity between splines, which take its velocity.
#include "core/errors.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace constant_velocity_test {

using namespace testing_support;

/// Up to 20 % of the lift, at constant velocity to 80 % in 60 deg, and on to the top.
Scene cutter_scene() {
    return program(
        {dwell(60), spline(50, 0.2), law(60, "constant_velocity", 0.8), spline(50, 1.0), spline(140, 0.0)});
}

std::string refusal(const Scene& scene) {
    return testing_support::refusal([&] { (void)solve(scene); });
}

TEST(ConstantVelocity, IsLinearWithMovableEnds) {
    const auto law = make_law("constant_velocity");
    EXPECT_FALSE(law->info().rests);
    EXPECT_EQ(law->info().continuity, 0);
    for (const double x : {0.0, 0.3, 0.5, 0.9, 1.0})
        EXPECT_EQ(law->derivatives(x), (LawDerivatives{x, 1.0, 0.0, 0.0, 0.0})) << x;
    EXPECT_EQ(law->peaks().velocity.value, 1.0);
    EXPECT_EQ(law->peaks().acceleration.value, 0.0);
    for (const LawInfo& other : law_catalogue())
        EXPECT_EQ(other.rests, other.key != "constant_velocity" && other.key != "polynomial" &&
                                   !other.key.starts_with("run_"))
            << other.key;
}

TEST(ConstantVelocity, RunInLeadsFromRest) {
    const auto in = make_law("run_in"), out = make_law("run_out");
    for (const double x : {0.0, 0.25, 0.5, 1.0}) {
        const LawDerivatives there = in->derivatives(x), mirrored = out->derivatives(1.0 - x);
        EXPECT_DOUBLE_EQ(there[0], 2.0 * x * x * x - x * x * x * x);
        for (std::size_t order = 0; order < 5; ++order)
            EXPECT_NEAR(there[order],
                        (order == 0 ? 1.0 : 0.0) - (order % 2 == 0 ? 1.0 : -1.0) * mirrored[order], 1e-14);
    }
    // Rest, run-in to 20 mm over 60 deg, as fast on to 40 mm over 30 deg, and a spline back.
    Scene scene =
        program({law(60, "run_in", 0.25), law(30, "constant_velocity", 0.5), spline(200, 0.0), dwell(70)});
    EXPECT_EQ(solve(scene).certificate.verdict, Verdict::optimal);
    scene.motion.segments[1].to = 0.6;
    EXPECT_TRUE(says(refusal(scene), "next to motion.segments[1] of kind \"law\" with another velocity"));
}

TEST(ConstantVelocity, NeighboursJoinWithItsVelocity) {
    for (const int spline_degree : {3, 5}) {
        Scene scene = cutter_scene();
        scene.spline.degree = spline_degree;
        const Solution solution = solve(scene);
        ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
        const Motion& motion = *solution.motion;
        const double velocity = 0.6 / (60.0 / 50.0);  // lifts per 50 deg
        for (const double x : {110.0 / 50.0, 170.0 / 50.0}) {
            for (const Side side : {Side::left, Side::right}) {
                EXPECT_NEAR(motion.at(x, side).derivative[1], velocity, 1e-10) << x;
                EXPECT_NEAR(motion.at(x, side).derivative[2], 0.0, 1e-9) << x;
            }
        }
        EXPECT_TRUE(std::isfinite(solution.motion_peaks.acceleration.value));
        EXPECT_GE(solution.segments[2].continuity, 2);
    }
}

TEST(ConstantVelocity, NeedsSplinesNextToIt) {
    Scene scene = cutter_scene();
    scene.motion.segments[3] = law(50, "cycloidal", 1.0);
    EXPECT_TRUE(says(refusal(scene),
                     "motion.segments[2].law: found \"constant_velocity\", a law whose ends "
                     "move, next to motion.segments[3] of kind \"law\""));
    scene = cutter_scene();
    scene.motion.segments[1].kind = SegmentKind::dwell;
    scene.motion.segments[1].to.reset();
    EXPECT_TRUE(says(refusal(scene), "of kind \"dwell\""));
    scene = cutter_scene();
    scene.motion.closed = false;
    scene.motion.segments = {scene.motion.segments[2], scene.motion.segments[3]};
    EXPECT_EQ(refusal(scene), "no refusal") << "a program that is not closed may start with it";
}

TEST(ConstantVelocity, IsNoReference) {
    Scene scene = cutter_scene();
    scene.objective.reference = {};
    scene.objective.reference.law = "constant_velocity";
    scene.objective.acceleration = scene.objective.jerk = 0.0;
    EXPECT_EQ(refusal(scene),
              "objective.reference: found \"constant_velocity\", a law whose ends move; allowed: a law that "
              "rests at "
              "its ends, or numbers");
}

TEST(ConstantVelocity, HasNoRestingNeighbours) {
    const Comparison comparison = compare(cutter_scene());
    ASSERT_EQ(comparison.optimum.certificate.verdict, Verdict::optimal);
    for (const ComparisonRow& row : comparison.rows) {
        EXPECT_NE(row.key, "constant_velocity");
        if (row.is_optimum()) continue;
        if (row.key == "polynomial") {  // takes the velocity
            EXPECT_TRUE(row.motion);
            continue;
        }
        EXPECT_EQ(row.misfit, "rests at its ends, where segment 3 moves on") << row.key;
    }
}

}  // namespace constant_velocity_test
}  // namespace camopt
