// SPDX-License-Identifier: MIT
// Scenes with the torque peak max |y' y''| in their objective.
#include "objectives/scene_model.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/counting_clock.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace torque_test {

using namespace testing_support;

// Of the modified sine, MATH: 5.4578; no motion from rest to rest has less than 9/4, where y'² grows linearly
// to the middle: y' = √(2 Q x), y(½) = ½.
constexpr double modified_sine_torque = 5.4578;
constexpr double least_torque = 2.25;

// Seconds are readings of the clock: the search takes a few hundred, the others go into bounds that do not
// meet it.
TestScene torque_scene(const char* objective, int segments, const char* type = "DRD") {
    return scene_named("drd_torque")
        .with(std::string("objective = ") + objective, "solver.max_seconds = 2000")
        .set("motion.type", type)
        .set("spline.segments", segments);
}

Solution counted(const Scene& scene) {
    CountingClock clock;
    return solve(scene, clock.control());
}

double dense_torque(const Motion& motion, double end) {
    double largest = 0.0;
    for (int k = 0; k <= 50000; ++k) {
        const MotionPoint point = motion.at(end * k / 50000);
        largest = std::max(largest, std::abs(point.derivative[1] * point.derivative[2]));
    }
    return largest;
}

/// Not convex: searched, and bounded over boxes as far as that goes.
void expect_searched(const Solution& solution, double end) {
    ASSERT_TRUE(solution.motion);
    const Verdict verdict = solution.certificate.verdict;
    EXPECT_TRUE(verdict == Verdict::local || verdict == Verdict::optimal) << solution.certificate.reason;
    EXPECT_FALSE(solution.solver.convex);
    EXPECT_NEAR(solution.peaks.torque.value, dense_torque(*solution.motion, end),
                1e-6 * solution.peaks.torque.value);
}

TEST(Torque, AloneStaysBelowModifiedSine) {
    double before = modified_sine_torque;
    for (const int segments : {8, 16}) {
        const Solution solution = counted(torque_scene("{ torque = 1 }", segments));
        expect_searched(solution, 1.0);
        EXPECT_LT(solution.peaks.torque.value, before);
        EXPECT_GT(solution.peaks.torque.value, least_torque);
        EXPECT_NEAR(solution.certificate.objective,
                    solution.peaks.torque.value / solution.reference_peaks.torque.value, 1e-9);
        before = solution.peaks.torque.value;
    }
}

TEST(Torque, WithOtherPeaksBeatsModifiedSine) {
    const TestScene scene =  // the bound meets it
        torque_scene("{ velocity = 0.1, acceleration = 0.2, jerk = 0.2, torque = 0.5 }", 16)
            .with("solver.max_seconds = 1e6");
    const Solution solution = counted(scene);
    expect_searched(solution, 1.0);
    EXPECT_LT(solution.peaks.torque.value, modified_sine_torque);
    EXPECT_LT(solution.certificate.objective, 1.0) << "what the modified sine itself has";
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << "over boxes";
    ASSERT_TRUE(solution.certificate.lower_bound);
    EXPECT_LE(*solution.certificate.lower_bound, solution.certificate.objective);
    EXPECT_GE(*solution.certificate.lower_bound, solution.certificate.objective - 1e-4);
    EXPECT_FALSE(solution.any_curve_limit) << "it knows no torque";
    // With the torque out of the objective its peak is larger: the term does what it is for.
    EXPECT_GT(counted(scene.with("objective.torque = 0")).peaks.torque.value,
              solution.peaks.torque.value + 1e-3);
}

TEST(Torque, OfARiseAndReturn) {
    const TestScene scene = torque_scene("{ torque = 1, jerk = 0.2 }", 16, "RR");
    const Solution solution = counted(scene);
    expect_searched(solution, 2.0);
    EXPECT_GT(counted(scene.with("objective.torque = 0")).peaks.torque.value,
              solution.peaks.torque.value + 1e-3);
}

TEST(Torque, DividesByItsOwnReference) {
    const Solution solution = counted(torque_scene("{ torque = 1, reference = { torque = 2 } }", 8));
    ASSERT_TRUE(solution.motion);
    EXPECT_NEAR(solution.certificate.objective, solution.peaks.torque.value / 2.0, 1e-9);
    EXPECT_EQ(solution.reference_peaks.torque.value, 2.0);
}

}  // namespace torque_test
}  // namespace camopt
