// SPDX-License-Identifier: MIT
// How far one number of a scene can go: values known from elsewhere, what is claimed of them, what is
// refused.
#include "studies/least/least_value.hpp"

#include "input/scene_text.hpp"
#include "report/solve/least_words.hpp"
#include "studies/least/monotone.hpp"
#include "studies/pareto/pareto_front.hpp"
#include "studies/solve/solve.hpp"
#include "studies/surface/trade_off_surface.hpp"
#include "studies/sweep/sweep_plan.hpp"
#include "tests/support/scene_kit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace camopt {
namespace least_value_test {

using namespace testing_support;
using testing::HasSubstr;

Solution least_of(const TestScene& scene, const std::string& key, double gap = 1e-6) {
    return solve(
        scene.with(fmt::format("objective.least = '{}'", key), fmt::format("objective.least_gap = {}", gap)));
}
Solution largest_of(const TestScene& scene, const std::string& key, double gap = 1e-6) {
    return solve(scene.with(fmt::format("objective.largest = '{}'", key),
                            fmt::format("objective.least_gap = {}", gap)));
}

/// A proved value that encloses the known one, which has so many digits.
void expect_encloses(const Solution& solution, double known, double digit, double gap = 1e-6) {
    ASSERT_TRUE(solution.least);
    const LeastReport& least = *solution.least;
    EXPECT_EQ(least.verdict, Verdict::optimal);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_TRUE(least.impossible && least.proof);
    const double low = std::min(least.value, *least.impossible),
                 high = std::max(least.value, *least.impossible);
    EXPECT_LE(low, known + digit);
    EXPECT_GE(high, known - digit);
    EXPECT_LE(high - low, gap * std::abs(known) * (1.0 + 1e-9));
    EXPECT_EQ(least.proof->certificate.verdict, Verdict::infeasible);
}

// References of independent programs (docs/least_value.md).

TEST(LeastValue, PressureAngleOfGivenCam) {
    expect_encloses(least_of(pressure_angle_scene(35.0), "limits.pressure_angle_deg"), 25.213433, 1e-6);
    expect_encloses(least_of(pressure_angle_scene(27.00587), "limits.pressure_angle_deg"), 30.000003, 1e-6);
}

TEST(LeastValue, BaseRadiusForGivenPressureAngle) {
    expect_encloses(least_of(pressure_angle_scene(35.0), "cam.base_radius_mm"), 17.005875, 1e-5);
}

TEST(LeastValue, PeaksOfFreeRise) {
    const TestScene scene = scene_named("drd_cubic_12");
    expect_encloses(least_of(scene, "limits.jerk"), 32.0, 1e-9);  // of any curve
    // y'' rises from 0 within the first of n = 12 segments and changes sign within two: 4 n / (n - 2).
    expect_encloses(least_of(scene, "limits.acceleration"), 4.8, 1e-9);
}

TEST(LeastValue, PeakOfWholeCycleInUnits) {
    expect_encloses(least_of(scene_named("48_weld"), "limits.acceleration_in_s2"), 292.0744, 1e-4);
    expect_encloses(least_of(scene_named("55_die"), "limits.acceleration_m_s2"), 2.89424, 1e-5);
}

TEST(LeastValue, SpringForGivenContactForce) {
    expect_encloses(least_of(scene_named("45c_respecify"), "forces.preload_n"), 8.87707, 1e-5);
    expect_encloses(least_of(scene_named("45c_respecify"), "forces.spring_rate_n_m"), 227.032, 1e-3);
}

TEST(LeastValue, SpeedAtWhichFollowerLosesContact) {
    const TestScene scene =
        scene_named("45c_respecify")
            .with("forces.preload_n = 1", "forces.damping_n_s_m = 0", "motion.speed_rpm = 60");
    const Solution solution = largest_of(scene, "motion.speed_rpm");
    expect_encloses(solution, solution.least->value, 1e-3);
    Scene faster = solution.scene;
    faster.objective.sought.reset();
    faster.motion.speed = *faster.motion.speed * 1.001;
    EXPECT_EQ(solve(faster).certificate.verdict, Verdict::infeasible);
    EXPECT_EQ(tightening_of(scene, "motion.speed_rpm"), Tightens::upward);
    EXPECT_EQ(tightening_of(scene.with("forces.damping_n_s_m = 1"), "motion.speed_rpm"), std::nullopt);
}

// What is claimed.

TEST(LeastValue, IsSameFromAnyGivenValue) {
    const TestScene scene = pressure_angle_scene(35.0);
    for (const char* const given : {"limits.pressure_angle_deg = 24", "limits.pressure_angle_deg = 26",
                                    "limits.pressure_angle_deg = 80"})
        expect_encloses(least_of(scene.with(given), "limits.pressure_angle_deg"), 25.213433, 1e-6);
}

TEST(LeastValue, WeightsChooseAmongMotionsAtIt) {
    const Solution solution = least_of(pressure_angle_scene(35.0), "limits.pressure_angle_deg", 1e-3);
    Scene same = solution.scene;
    EXPECT_EQ(same.objective.sought, (SoughtKey{"limits.pressure_angle_deg"}));
    same.objective.sought.reset();
    EXPECT_NEAR(same.limits.pressure_angle->given(), solution.least->value, 1e-12);
    EXPECT_NEAR(solve(same).certificate.objective, solution.certificate.objective, 1e-7);
}

TEST(LeastValue, IsLocalWhereNotMonotone) {
    const Solution solution = least_of(pressure_angle_scene(35.0), "motion.rise_deg", 1e-4);
    ASSERT_TRUE(solution.least && solution.least->impossible);
    EXPECT_EQ(solution.least->verdict, Verdict::local);
    EXPECT_LT(*solution.least->impossible, solution.least->value);
}

TEST(LeastValue, ShrinkingDwellHasFewDigits) {
    const TestScene scene(R"(
motion = { type = "program", lift_mm = 10, speed_rpm = 100, segments = [
    { kind = "spline", angle_deg = 60, to = 1 }, { kind = "dwell", angle_deg = 60 },
    { kind = "spline", angle_deg = 120, to = 0 }, { kind = "dwell", angle_deg = 120 } ] }
objective = { jerk = 1 }
limits = { acceleration_m_s2 = 4 }
)");
    const Solution solution = least_of(scene, "motion.segments[0].angle_deg", 1e-4);
    ASSERT_TRUE(solution.least && solution.least->proof);
    for (const Scene& one : {solution.scene, solution.least->proof->scene})
        EXPECT_THAT(input::scene_text(one), testing::Not(testing::ContainsRegex("[0-9][.][0-9]{8}")));
}

TEST(LeastValue, EndOfRangeNeedsNoProof) {
    const TestScene scene = pressure_angle_scene(35.0).with(
        "motion.speed_rpm = 6", "forces.mass_kg = 0.01", "forces.spring_rate_n_mm = 1",
        "forces.preload_n = 5", "limits.contact_force_min_n = 0");
    const Solution solution = least_of(scene, "forces.preload_n");
    ASSERT_TRUE(solution.least);
    EXPECT_EQ(solution.least->value, 0.0);
    EXPECT_EQ(solution.least->verdict, Verdict::optimal);
    EXPECT_FALSE(solution.least->impossible || solution.least->proof);
}

TEST(LeastValue, NumberThatNeedsNothingIsZero) {
    const TestScene flat = flat_scene(60.0).with("limits = {}");
    const Solution solution = least_of(flat, "limits.pressure_angle_deg", 1e-4);  // of a pushed face always 0
    ASSERT_TRUE(solution.motion && solution.least);
    EXPECT_GT(solution.least->value, 1e-9);
    EXPECT_LT(solution.least->value, 1e-2);
    EXPECT_EQ(solution.least->verdict, Verdict::feasible);
    EXPECT_FALSE(solution.least->impossible);
    EXPECT_NE(least_sentence(solution).find("practically 0"), std::string::npos);
    // Of a number that may be 0 it is 0.
    const TestScene pressed = pressure_angle_scene(35.0).with(
        "motion.speed_rpm = 6", "forces = { mass_kg = 0.01, spring_rate_n_mm = 1, preload_n = 5 }",
        "limits.contact_force_min_n = 0");
    EXPECT_EQ(least_of(pressed, "forces.preload_n").least->value, 0.0);
}

TEST(LeastValue, InfeasibleWithEveryValueIsInfeasible) {
    const Solution solution = least_of(scene_named("infeasible_velocity_cap"), "limits.acceleration");
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_FALSE(solution.least);
}

// What is refused.

std::string refusal(const std::function<void()>& what) {
    try {
        what();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(LeastValue, RefusesKeysThatItCannotSeek) {
    const TestScene scene = pressure_angle_scene(35.0);
    EXPECT_THAT(refusal([&] { (void)least_of(scene, "limits.pressure"); }),
                HasSubstr("objective.least: found \"limits.pressure\"; allowed: "));
    EXPECT_THAT(refusal([&] { (void)least_of(scene, "limits.cam_radius_min_mm"); }),
                HasSubstr("found \"limits.cam_radius_min_mm\", a least value"));
    EXPECT_THAT(refusal([&] { (void)largest_of(scene, "limits.pressure_angle_deg"); }),
                HasSubstr("found \"limits.pressure_angle_deg\", a largest value"));
    EXPECT_THAT(refusal([&] { (void)least_of(scene_named("drd_cubic_12"), "limits.pressure_angle_deg"); }),
                HasSubstr("which this scene cannot have"));
    EXPECT_THAT(refusal([&] { (void)solve(scene.with("objective.least = 'a'", "objective.largest = 'b'")); }),
                HasSubstr("largest"));
}

TEST(LeastValue, IsRefusedByFrontsAndSurfaces) {
    const Scene scene = pressure_angle_scene(35.0).with("objective.least = 'limits.pressure_angle_deg'");
    EXPECT_THAT(refusal([&] { FrontRequest().validate(scene); }), HasSubstr("seeks no number"));
    EXPECT_THAT(refusal([&] { (void)trade_off_surface(scene, {}, {}); }), HasSubstr("seeks no number"));
}

// Where it goes.

TEST(LeastValue, IsColumnOfSweeps) {
    const TestScene scene = pressure_angle_scene(35.0).with("objective.least = 'limits.pressure_angle_deg'");
    SweepRow row = sweep_row(0, {}, solve(scene));
    ASSERT_TRUE(row.sought.value && row.sought.impossible);
    EXPECT_NEAR(*row.sought.value, 25.2134, 2e-3);
}

}  // namespace least_value_test
}  // namespace camopt
