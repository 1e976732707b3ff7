// SPDX-License-Identifier: MIT
// Limits set from C++ with nothing but their number: reported with key, unit and value all the same.
#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace camopt {
namespace embedder_limits_test {

using namespace testing_support;

Scene rise() {
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    scene.motion.lift = 10.0 * units::millimetre;
    scene.motion.rise = 120.0 * units::degree;
    return scene;
}

Scene roller_cam() {
    Scene scene = rise();
    scene.cam = disk_spec({});
    scene.cam->set(DimensionIndex::base_radius, 40.0 * units::millimetre);
    scene.cam->set(DimensionIndex::roller_radius, 10.0 * units::millimetre);
    return scene;
}

ConstraintReport only(const Solution& solution) {
    EXPECT_EQ(solution.constraints.size(), 1U);
    return solution.constraints.front();
}

TEST(LimitsFromCpp, NormalisedCapReportsItsKey) {
    Scene scene = rise();
    scene.limits.velocity = PeakLimit(1.7);
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);
    const ConstraintReport report = only(solution);
    EXPECT_EQ(report.key, "limits.velocity");
    EXPECT_EQ(report.unit, "");
    EXPECT_EQ(report.limit, 1.7);
    EXPECT_NEAR(report.worst, 1.7, 1e-8);
    EXPECT_TRUE(report.active);
}

TEST(LimitsFromCpp, TimeCapNeedsOnlyUnit) {
    Scene scene = rise();
    scene.motion.speed = 300.0 * units::revolution_per_minute;
    const double per_unit = 10.0 * (300.0 * std::numbers::pi / 30.0) / scene.motion.rise;  // mm/s
    for (const PeakLimit& limit :
         {PeakLimit(1.7, {}, 0.0, "mm/s"), PeakLimit(0.0, {}, 1.7 * per_unit, "mm/s"),
          PeakLimit(0.0, "limits.velocity_mm_s", 1.7 * per_unit)}) {
        scene.limits.velocity = limit;
        const ConstraintReport report = only(solve(scene));
        EXPECT_EQ(report.key, "limits.velocity_mm_s");
        EXPECT_EQ(report.unit, "mm/s");
        EXPECT_NEAR(report.limit, 1.7 * per_unit, 1e-9 * per_unit);
        EXPECT_NEAR(report.worst, 1.7 * per_unit, 1e-7 * per_unit);
    }
}

TEST(LimitsFromCpp, RelaxationReportsGivenAndNeeded) {
    Scene scene = rise();
    scene.limits.velocity = PeakLimit(0.9);
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    ASSERT_FALSE(solution.relaxation.empty());
    EXPECT_EQ(solution.relaxation.front().key, "limits.velocity");
    EXPECT_EQ(solution.relaxation.front().given, 0.9);
    ASSERT_TRUE(solution.relaxation.front().needed);
    EXPECT_GT(*solution.relaxation.front().needed, 1.0);
    ASSERT_FALSE(solution.conflict.empty());
    EXPECT_EQ(solution.conflict.front().key, "limits.velocity");
}

TEST(LimitsFromCpp, CamLimitUsesManualUnit) {
    Scene scene = roller_cam();
    scene.limits.pressure_angle = WrittenLimit(20.0 * units::degree);
    const ConstraintReport report = only(solve(scene));
    EXPECT_EQ(report.name, "pressure_angle");
    EXPECT_EQ(report.key, "limits.pressure_angle_deg");
    EXPECT_EQ(report.unit, "deg");
    EXPECT_EQ(report.limit, 20.0);
    EXPECT_GT(report.worst, 1.0);
    EXPECT_LE(report.worst, 20.0 + 1e-6);
}

TEST(LimitsFromCpp, CamLimitKeepsSelectedUnit) {
    Scene scene = roller_cam();
    scene.limits.cam_radius_min = WrittenLimit(1.0 * units::inch, {}, units::inch, "in");
    scene.limits.pressure_angle = WrittenLimit(0.35, "limits.pressure_angle_rad");
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.constraints.size(), 2U);
    EXPECT_EQ(solution.constraints[0].key, "limits.pressure_angle_rad");
    EXPECT_EQ(solution.constraints[0].unit, "rad");
    EXPECT_EQ(solution.constraints[0].limit, 0.35);
    EXPECT_EQ(solution.constraints[1].key, "limits.cam_radius_min_in");
    EXPECT_EQ(solution.constraints[1].unit, "in");
    EXPECT_EQ(solution.constraints[1].limit, 1.0);
}

TEST(LimitsFromCpp, CamChangesHaveKeys) {
    Scene scene = roller_cam();
    scene.limits.pressure_angle = WrittenLimit(5.0 * units::degree);
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    const auto remedy = std::ranges::find(solution.relaxation, "limits.pressure_angle_deg", &Relaxation::key);
    ASSERT_NE(remedy, solution.relaxation.end());
    EXPECT_EQ(remedy->given, 5.0);
    for (const Relaxation& one : solution.relaxation) EXPECT_FALSE(one.key.empty());
    for (const ConflictReport& one : solution.conflict)
        EXPECT_TRUE(one.key.starts_with("limits.")) << one.key;
}

TEST(LimitsFromCpp, AComparisonNamesThem) {
    Scene scene = roller_cam();
    scene.limits.velocity = PeakLimit(1.7);
    scene.limits.pressure_angle = WrittenLimit(20.0 * units::degree);
    const Comparison comparison = compare(scene);
    ASSERT_FALSE(comparison.rows.empty());
    for (const ComparisonRow& row : comparison.rows)
        for (const LimitOutcome& outcome : row.limits) {
            EXPECT_TRUE(outcome.reached.key.starts_with("limits.")) << row.key;
            EXPECT_GT(outcome.reached.limit, 0.0);
        }
}

TEST(LimitsFromCpp, ContradictoryNumbersAreRefused) {
    Scene scene = rise();
    const auto refused = [&] { return refusal([&] { (void)solve(scene); }); };
    scene.limits.velocity = PeakLimit(1.7, {}, 5.0);
    EXPECT_EQ(refused(),
              "limits.velocity: found normalised 1.7 together with given 5; allowed: one of them, or two "
              "equal values");
    scene.limits.velocity = PeakLimit(0.0, {}, 5.0, "furlong/s");
    EXPECT_EQ(refused(),
              "limits.velocity: found the unit \"furlong/s\"; allowed: none (normalised), or mm/s, in/s, "
              "m/s, deg/s, rad/s, mm/rad, in/rad, m/rad, mm/deg, in/deg, deg/deg, rad/rad");
}

}  // namespace embedder_limits_test
}  // namespace camopt
