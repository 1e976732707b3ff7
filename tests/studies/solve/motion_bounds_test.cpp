// SPDX-License-Identifier: MIT
// Limits of one side, corridors and the area under the curve: reference optima of independent linear
// programs, and every bound looked at again on the delivered motion.
#include "objectives/motion_bounds.hpp"

#include "core/units.hpp"
#include "studies/search/planned_solve.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace camopt {
namespace motion_bounds_test {

using namespace testing_support;

/// The largest of sign · y^(order) on a dense grid of [from, until].
double largest(const Motion& motion, std::size_t order, int sign, double from, double until) {
    constexpr int places = 20000;
    double found = -infinity;
    for (int k = 0; k <= places; ++k) {
        const double x = from + (until - from) * k / places;
        found = std::max(found, sign * motion.at(x, k < places ? Side::right : Side::left).derivative[order]);
    }
    return found;
}

const ConstraintReport& report_of(const Solution& solution, const std::string& key) {
    const auto found = std::ranges::find(solution.constraints, key, &ConstraintReport::key);
    if (found == solution.constraints.end()) throw InputError("no constraint " + key);
    return *found;
}

struct Lobe {
    int segments;
    double up, down, jerk;
    double area_weight, jerk_weight;
    double objective;  ///< of an independent linear program
};

class ValveLobe : public testing::TestWithParam<Lobe> {};

TEST_P(ValveLobe, MatchesTheIndependentOptimum) {
    const Lobe& lobe = GetParam();
    Scene scene = TestScene(
        "[motion]\ntype = \"RR\"\n[objective]\narea = 1\nreference = { area = 0.5, jerk = 36.5 }\n");
    scene.spline.segments = lobe.segments;
    scene.spline.by_stroke = false;
    scene.motion.within_lift = false;  // area is gained above the lift
    scene.objective.area = lobe.area_weight;
    scene.objective.jerk = lobe.jerk_weight;
    scene.limits.acceleration_max = PeakLimit(lobe.up);
    scene.limits.acceleration_min = PeakLimit(-lobe.down);
    scene.limits.jerk = PeakLimit(lobe.jerk);
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    EXPECT_NEAR(solution.certificate.objective, lobe.objective, 1e-7);
    EXPECT_LE(largest(*solution.motion, 2, 1, 0.0, 2.0), lobe.up * (1.0 + 1e-8));
    EXPECT_LE(largest(*solution.motion, 2, -1, 0.0, 2.0), lobe.down * (1.0 + 1e-8));
    EXPECT_NEAR(report_of(solution, "limits.acceleration.min").worst, -lobe.down, 1e-6);
    EXPECT_TRUE(report_of(solution, "limits.acceleration.min").active);
}

INSTANTIATE_TEST_SUITE_P(Weights, ValveLobe,
                         testing::Values(Lobe{24, 7.0, 4.5, 60.0, 1.0, 0.0, 0.9279996142},
                                         Lobe{32, 9.0, 4.5, 150.0, 1.0, 0.0, 0.7758225151},
                                         Lobe{32, 9.0, 4.5, 150.0, 0.7, 0.3, 0.9760438746}));

TEST(LostArea, OfEveryLawIsOneHalf) {
    const Scene scene = TestScene("[motion]\ntype = \"DRD\"\n[objective]\narea = 1\njerk = 1\n");
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.own_terms.size(), 1U);
    EXPECT_NEAR(solution.own_terms[0].reference, 0.5, 1e-12);  // modified sine
    double sum = 0.0;
    constexpr int places = 20000;
    for (int k = 0; k < places; ++k) sum += solution.motion->at((k + 0.5) / places).derivative[0] / places;
    EXPECT_NEAR(solution.own_terms[0].value, 1.0 - sum, 1e-8);
    EXPECT_NEAR(
        solution.certificate.objective,
        solution.own_terms[0].value / 0.5 + solution.peaks.jerk.value / solution.reference_peaks.jerk.value,
        1e-8);
}

/// Small weights are solved scaled.
TEST(LostArea, SmallWeightScalesTheObjective) {
    Scene scene = TestScene("[motion]\ntype = \"DRD\"\n[objective]\narea = 1\n[limits]\njerk = 80\n");
    const double whole = solve(scene).certificate.objective;
    scene.objective.area = 0.01;
    const Solution small = solve(scene);
    EXPECT_EQ(small.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(small.certificate.objective, 0.01 * whole, 1e-9);
    EXPECT_EQ(small.own_terms.at(0).weight, 0.01);
}

/// A cost that is not convex is bounded over boxes, the area with it.
TEST(LostArea, IsProvedWithTorqueTerm) {
    const Solution solution =
        solve(TestScene("[motion]\ntype = \"DRD\"\n[spline]\nsegments = 6\n[objective]\narea = 0.5\ntorque = "
                        "0.5\n[limits]\njerk = 90\n"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
}

/// Bounds of all four derivatives on stretches that no breakpoint meets; the ends belong to the stretch.
TEST(Corridor, HoldsAtEveryAngleOfItsStretch) {
    const Scene scene = scene_named("corridors");
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    const Motion& motion = *solution.motion;
    EXPECT_LE(largest(motion, 0, 1, 21.0 / 120.0, 41.0 / 120.0), 0.1 + 1e-8);
    const double per_second = 1800.0 / 120.0, lift = 0.01;  // x in a second, m
    EXPECT_GE(-largest(motion, 1, -1, 61.5 / 120.0, 83.2 / 120.0) * lift * per_second, 0.06 - 1e-8);
    EXPECT_LE(largest(motion, 1, 1, 61.5 / 120.0, 83.2 / 120.0) * lift * per_second, 0.26 + 1e-8);
    EXPECT_LE(largest(motion, 2, 1, 61.5 / 120.0, 83.2 / 120.0) * lift * per_second * per_second, 4.0 + 1e-7);
    const ConstraintReport& displacement = report_of(solution, "motion.corridor[0].displacement_mm.max");
    EXPECT_EQ(displacement.limit, 1.0);
    EXPECT_NEAR(displacement.worst, 1.0, 1e-6);
    EXPECT_TRUE(displacement.active);
    Scene without = scene;
    without.motion.corridors.clear();
    EXPECT_LT(solve(without).certificate.objective, solution.certificate.objective);
}

TEST(Corridor, ImpossibleOneIsProvedAndExplained) {
    Scene scene = TestScene(
        "[motion]\ntype = \"DRD\"\nlift_mm = 10\nrise_deg = 100\n[[motion.corridor]]\nto_deg = 60\n"
        "displacement_mm = { max = 0.5 }\n[objective]\njerk = 1\n[limits]\nacceleration = 8\n");
    const Solution solution = solve(scene);
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
    const auto row =
        std::ranges::find(solution.relaxation, "motion.corridor[0].displacement_mm.max", &Relaxation::key);
    ASSERT_NE(row, solution.relaxation.end());
    ASSERT_TRUE(row->solved);
    scene.motion.corridors[0].bounds[0].most = *row->solved / 10.0;
    EXPECT_EQ(solve(scene).certificate.verdict, Verdict::optimal);
}

/// Found by scripts/known: infeasible by 1e-6 of its rows, which took the whole time and was not proved while
/// the proof's box did not use that acceleration and jerk are limited.
TEST(Corridor, ContradictionByAMillionthIsProved) {
    const Scene scene = TestScene(R"([motion]
type = "DRD"
lift_mm = 52.0
speed_rpm = 148.0
rise_deg = 170.0
via = [{ at = 0.93591641901528511, velocity_mm_rad = 0.34234344982371862 }]
[[motion.corridor]]
from_deg = 146.991727124504
to_deg = 151.68316628707495
velocity_m_rad = { min = 0.00023220059334150327 }
[[motion.corridor]]
from_deg = 130.95519423419478
to_deg = 133.04979273352012
jerk = { min = -6.8420798750871299 }
[[motion.corridor]]
from_deg = 13.042546260097257
to_deg = 22.480547651920574
velocity_m_rad = { max = 0.0055944358889890708 }
[spline]
degree = 7
segments = 7
rest = 4
[dynamics]
mass_kg = 1.9000000000000001
stiffness_n_mm = 375.0
prescribe = "output"
[objective]
velocity = 1
acceleration = 1
[limits]
velocity = { max = 2.0851132103476036 }
acceleration_in_deg2 = { max = 0.00051896774949003412, min = -0.00052381154179223727 }
jerk_mm_s3 = { max = 453911.04286510654, min = -480085.69729532354 }
cam_velocity_mm_deg = { max = 0.68932427560857823 }
)");
    const Solution solution = solve_without_explaining(scene, {});
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible) << solution.certificate.reason;
    EXPECT_NEAR(solution.certificate.proof->bound, 1.047e-6, 1e-9);
    EXPECT_LT(solution.seconds_solve, 2.0);
}

TEST(Corridor, BeginsWhereALawEnds) {
    // The jerk of the law at its end is above 600 mm/rad³: a corridor that begins a rounding earlier is not
    // meant for it.
    const auto begins_at = [](const std::string& from_deg) {
        return TestScene(
            "[motion]\ntype = \"program\"\nlift_mm = 10\n[[motion.segments]]\nkind = \"law\"\n"
            "law = \"cycloidal\"\nangle_deg = 33.3\nto = 0.3\n[[motion.segments]]\n"
            "kind = \"spline\"\nangle_deg = 66.7\nto = 1\n[[motion.segments]]\nkind = \"dwell\"\n"
            "angle_deg = 100\n[[motion.segments]]\nkind = \"spline\"\nangle_deg = 160\nto = 0\n"
            "[[motion.corridor]]\nfrom_deg = " +
            from_deg +
            "\nto_deg = 60\njerk_mm_rad3 = { max = 500 }\n[objective]\njerk = 1\n"
            "[spline]\nsegments = 6\n");
    };
    EXPECT_EQ(solve(begins_at("33.29999999999999")).certificate.verdict, Verdict::optimal);
    EXPECT_EQ(solve(begins_at("33.2")).certificate.verdict, Verdict::infeasible);
}

TEST(SidedLimit, InTimeHoldsForAProgram) {
    const Solution solution = solve(scene_named("sided_program"));
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    EXPECT_NEAR(solution.motion->at(0.0).derivative[1], 0.0, 1e-9)
        << "the turn ends and starts at its lowest point";
    const double rate = 200.0 * units::revolution_per_minute / (120.0 * units::degree);  // x in a second
    const double unit = 0.02 * rate * rate;
    EXPECT_LE(largest(*solution.motion, 2, 1, 0.0, 3.0) * unit, 14.0 + 1e-6);
    EXPECT_LE(largest(*solution.motion, 2, -1, 0.0, 3.0) * unit, 9.0 + 1e-6);
    EXPECT_NEAR(report_of(solution, "limits.acceleration_m_s2.min").worst, -9.0, 1e-5);
}

TEST(SidedLimit, VelocityAboveZeroIsMonotone) {
    Scene scene = TestScene(
        "[motion]\ntype = \"DRD\"\nvia = [{ at = 0.5, displacement = 0.2 }]\n[spline]\nsegments = 16\n"
        "[objective]\njerk = 1\n[limits]\nvelocity = { min = 0 }\n");
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    EXPECT_GE(-largest(*solution.motion, 1, -1, 0.0, 1.0), -1e-8);
    scene.limits.velocity_min.reset();
    scene.motion.monotone = true;
    EXPECT_NEAR(solve(scene).certificate.objective, solution.certificate.objective, 1e-7);
}

}  // namespace motion_bounds_test
}  // namespace camopt
