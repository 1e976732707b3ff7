// SPDX-License-Identifier: MIT
// The transmission of a motor as a range: the value that is found, what is claimed of it, and what is
// refused.
#include "report/json/result_json.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/solved_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace free_transmission_test {

using namespace testing_support;
using ::testing::HasSubstr;

/// A slide of 100 mm in 0.12 s of a cycle of 0.3 s, that nothing but inertia resists.
TestScene slide() {
    return scene_named("servo_slide")
        .set("spline.segments", 12)
        .with("drive.transmission_mm_per_rev = { min = 10, max = 200 }", "drive.viscous_n_s_m = 0",
              "drive.force_n = 0");
}

double millimetres_per_revolution(const Solution& solution) {
    return solution.scene.drive->transmission * 2e3 * std::numbers::pi;
}

// τ = (m r + J / r) a is least for r² = J / m, whatever the motion.
TEST(FreeTransmission, EqualInertiasNeedLeastTorque) {
    const double best = 2e3 * std::numbers::pi * std::sqrt(4e-4 / 8.0);
    const Solution solution = solve(slide());
    EXPECT_EQ(solution.certificate.verdict, Verdict::local);
    EXPECT_FALSE(solution.certificate.lower_bound);
    EXPECT_NEAR(millimetres_per_revolution(solution), best, 1e-3 * best);
    EXPECT_NEAR(*solution.scene.drive->inertia_ratio(), 1.0, 2e-3);
    EXPECT_TRUE(solution.scene.drive->transmission_range);
    for (const double other : {0.9 * best, 1.1 * best})
        EXPECT_GT(solve(slide().set("drive.transmission_mm_per_rev", other)).certificate.objective,
                  solution.certificate.objective);
    EXPECT_THAT(result_json(solution), HasSubstr("\"transmission_mm_per_rev\""));
}

TEST(FreeTransmission, LimitIsMetOnlyInside) {
    const double best = 2e3 * std::numbers::pi * std::sqrt(4e-4 / 8.0);
    const TestScene scene = slide().with("objective = { jerk = 1 }", "limits.motor_torque_nm = 4");
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.motion);
    EXPECT_LE(solution.drive->torque.value, 4.0 + 1e-6);
    for (const double end : {10.0, 200.0})
        EXPECT_EQ(solve(scene.set("drive.transmission_mm_per_rev", end)).certificate.verdict,
                  Verdict::infeasible);
    EXPECT_NEAR(millimetres_per_revolution(solution), best, best);
    const Solution none = solve(scene.with("limits.motor_torque_nm = 1", "solver.explain_seconds = 0"));
    EXPECT_EQ(none.certificate.verdict, Verdict::failed);
    EXPECT_EQ(none.certificate.reason, Reason::no_feasible_point);
}

TEST(FreeTransmission, WhatDependsOnNothingIsRefused) {
    const auto refused = [](const TestScene& scene) { return refusal([&] { (void)solve(scene); }); };
    EXPECT_THAT(refused(slide().with("objective = { jerk = 1 }")),
                HasSubstr("found a range without a limit or a term of the motor"));
    EXPECT_THAT(refused(slide().with("objective = { motor_torque_rms = 1 }")),
                HasSubstr("objective.reference.motor_torque_rms as a number"));
}

}  // namespace free_transmission_test
}  // namespace camopt
