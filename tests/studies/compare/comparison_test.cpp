// SPDX-License-Identifier: MIT
// Laws beside the optimum: figures known in closed form, or computed here a second way.
#include "studies/compare/comparison.hpp"

#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "studies/laws/law_motion.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace camopt {
namespace comparison_test {

using std::numbers::pi;
using namespace testing_support;

/// Weights 0.4, 0.4, 0.2 over the peaks of the modified sine.
TestScene scene_of(const char* type, int segments) {
    return scene_named("drd_cubic_12")
        .with("objective.reference = modified_sine")
        .set("motion.type", type)
        .set("spline.segments", segments);
}

/// docs/theory/pressure_angle.md: lift 20 mm in 60 deg, roller 10 mm, |φ| <= 30 deg.
TestScene pressure_scene(double base_mm) {
    return pressure_angle_scene(base_mm + 10.0).with("objective.reference = modified_sine");
}

/// Without segments: dwell, up, dwell, down, a quarter turn each.
Scene program_scene(std::vector<ProgramSegment> segments = {}) {
    if (segments.empty()) segments = {dwell(90), spline(90, 1.0), dwell(90), spline(90, 0.0)};
    Scene scene = program(std::move(segments));
    scene.objective.reference = {};
    return scene;
}

/// The laws that are a rise by themselves.
std::vector<LawInfo> rises() {
    std::vector<LawInfo> laws;
    for (const LawInfo& law : law_catalogue())
        if (law.rests) laws.push_back(law);
    return laws;
}

const ComparisonRow& row_of(const Comparison& comparison, const std::string& key) {
    const auto row = std::ranges::find(comparison.rows, key, &ComparisonRow::key);
    if (row == comparison.rows.end()) throw std::runtime_error("no row " + key);
    return *row;
}

TEST(Comparison, ListsEveryLawSorted) {
    const Comparison comparison = compare(scene_of("DRD", 12));
    EXPECT_EQ(comparison.rows.size(), rises().size() + 1);
    for (const LawInfo& law : rises()) {
        const ComparisonRow& row = row_of(comparison, law.key);
        EXPECT_EQ(row.misfit.empty(), law.top == TopEnd::dwell) << law.key;
        EXPECT_EQ(row.motion == nullptr, law.top == TopEnd::turning_point) << law.key;
    }
    for (std::size_t i = 0; i + 1 < comparison.rows.size(); ++i) {
        if (!comparison.rows[i + 1].misfit.empty()) break;
        EXPECT_LE(comparison.rows[i].objective, comparison.rows[i + 1].objective);
    }
    EXPECT_TRUE(comparison.rows.front().is_optimum());
    EXPECT_FALSE(comparison.cam);
}

/// A valve's flat tappet on a base circle so small that most laws undercut: they have smaller objectives than
/// the optimum, and stand below it all the same.
TEST(Comparison, InfeasibleLawsRankLast) {
    const Comparison comparison = compare(scene_of("RR", 24).with(
        "objective = { acceleration = 0.5, jerk = 0.5 }",
        "motion = { type = 'RR', lift_mm = 9, rise_deg = 65, speed_rad_s = 314.16 }",
        "cam = { type = 'disk', follower = 'translating_flat', base_radius_mm = 26 }",
        "forces = { mass_kg = 0.15, spring_rate_n_mm = 35, preload_n = 250, contact_width_mm = 12 }",
        "limits.hertz_pressure_max_mpa = 700"));
    bool broken_before = false;
    int feasible = 0, undercut = 0;
    for (const ComparisonRow& row : comparison.rows) {
        if (!row.misfit.empty()) break;
        EXPECT_FALSE(row.feasible && broken_before) << row.title;
        broken_before = broken_before || !row.feasible;
        feasible += row.feasible ? 1 : 0;
        if (!row.limits[0].reached.no_contact) {
            EXPECT_LT(row.limits[0].reached.worst, 1e5) << row.title;  // MPa: no figure of an undercut cam
            continue;
        }
        ++undercut;
        EXPECT_FALSE(row.feasible) << row.title;
    }
    EXPECT_TRUE(comparison.rows.front().feasible);
    EXPECT_GE(feasible, 1);
    EXPECT_GE(undercut, 1);
}

TEST(Comparison, ModifiedSinePeaksSumToWeights) {
    const Comparison comparison = compare(scene_of("DRD", 12));
    const ComparisonRow& row = row_of(comparison, "modified_sine");
    EXPECT_NEAR(row.objective, 1.0, 1e-14);
    const double optimum = comparison.optimum.certificate.objective;
    EXPECT_NEAR(*row.loss_percent, 100.0 * (1.0 / optimum - 1.0), 1e-9);
    EXPECT_TRUE(row.feasible);
    EXPECT_FALSE(row.base);
    EXPECT_EQ(row_of(comparison, "").loss_percent, 0.0);
}

TEST(Comparison, NoLawBeatsAnyCurveLimit) {
    const Comparison comparison = compare(scene_of("DRD", 12));
    for (const ComparisonRow& row : comparison.rows) {
        if (!row.misfit.empty()) continue;
        EXPECT_GE(row.objective, comparison.optimum.any_curve_limit->objective * (1.0 - 1e-9)) << row.key;
        EXPECT_EQ(row.loss_percent.has_value(), std::isfinite(row.objective)) << row.key;
        if (row.is_optimum()) continue;
        EXPECT_EQ(row.peaks.jerk.value, make_law(row.key)->peaks().jerk.value) << row.key;
        EXPECT_NEAR(row.peaks.rms_acceleration, make_law(row.key)->peaks().rms_acceleration, 1e-12);
    }
}

TEST(Comparison, InfiniteJerkCountsOnlyIfWeighted) {
    Scene scene = scene_of("DRD", 12);
    EXPECT_TRUE(std::isinf(row_of(compare(scene), "parabolic").objective));
    EXPECT_FALSE(row_of(compare(scene), "parabolic").loss_percent);
    scene.objective.jerk = 0.0;
    const ComparisonRow parabolic = row_of(compare(scene), "parabolic");
    EXPECT_NEAR(parabolic.objective, 0.4 * 2.0 / 1.759603 + 0.4 * 4.0 / 5.527957, 1e-5);
    EXPECT_TRUE(std::isinf(parabolic.peaks.jerk.value));
}

TEST(Comparison, ReportsAmountOfViolation) {
    const Comparison comparison = compare(scene_of("DRD", 12).with(
        "limits.velocity = 1.8", "motion.via = [{ at = 0.25, displacement = 0.1 }]"));
    const LimitOutcome& cycloidal = row_of(comparison, "cycloidal").limits[0];
    EXPECT_FALSE(cycloidal.kept);
    EXPECT_NEAR(cycloidal.excess, 0.2, 1e-12);
    EXPECT_TRUE(row_of(comparison, "modified_sine").limits[0].kept);
    const LimitOutcome& via = row_of(comparison, "cycloidal").limits[1];
    EXPECT_EQ(via.reached.key, "motion.via[0].displacement");
    EXPECT_NEAR(via.reached.worst, 0.25 - 1.0 / (2 * pi), 1e-12);
    EXPECT_FALSE(via.kept);
    EXPECT_FALSE(row_of(comparison, "modified_sine").feasible);
    EXPECT_TRUE(row_of(comparison, "").feasible);
}

// A law that misses a set point makes another motion, and a broken limit makes a law no better: neither has a
// loss that could be negative.
TEST(Comparison, ViolatedConditionsHaveNoLoss) {
    const TestScene scene = scene_of("DRD", 12);
    for (const ComparisonRow& row :
         compare(scene.with("motion.via = [{ at = 0.25, displacement = 0.02 }]")).rows)
        EXPECT_EQ(row.loss_percent.has_value(), row.is_optimum()) << row.key;
    const Comparison capped = compare(scene.with("limits.velocity = 1.4"));
    bool better_and_broken = false;
    for (const ComparisonRow& row : capped.rows) {
        if (row.loss_percent) {
            EXPECT_GE(*row.loss_percent, 0.0) << row.key;
        }
        better_and_broken |= !row.feasible && row.objective < capped.optimum.certificate.objective;
    }
    EXPECT_TRUE(better_and_broken);
}

TEST(Comparison, AsymmetricLawsDifferInEndJerk) {
    const Comparison comparison = compare(
        scene_of("DRD", 12).with("motion.symmetric = true", "spline.degree = 5", "spline.end_jerk = zero"));
    EXPECT_TRUE(row_of(comparison, "polynomial_4567").feasible);
    EXPECT_FALSE(row_of(comparison, "polynomial_345").feasible);
    for (const LimitOutcome& outcome : row_of(comparison, "polynomial_4567").limits)
        EXPECT_TRUE(outcome.reached.active) << outcome.reached.name << ": what must be exact always bites";
    EXPECT_NEAR(row_of(comparison, "polynomial_345").limits[1].reached.worst, 60.0, 1e-9);
    for (const ComparisonRow& row : comparison.rows) {
        if (!row.key.starts_with("asymmetric")) continue;
        EXPECT_FALSE(row.limits[0].kept) << row.key;
    }
}

TEST(Comparison, AxialRollerBaseRadiusMatchesDenseComputation) {
    const Comparison comparison = compare(pressure_scene(30));
    int seen = 0;
    for (const LawInfo& info : rises()) {
        if (info.top != TopEnd::dwell) continue;
        const std::unique_ptr<Law> law = make_law(info.key);
        double prime = 0.0;  // max of s'/tan φ − s
        std::vector<double> places = law->breakpoints();
        for (int k = 0; k <= 200000; ++k) places.push_back(k / 200000.0);
        for (const double x : places) {
            const MotionPoint point = law->at(x);
            const double slope = 20e-3 / (pi / 3) * point.derivative[1];
            prime = std::max(prime, slope / std::tan(pi / 6) - 20e-3 * point.derivative[0]);
        }
        const ComparisonRow& row = row_of(comparison, info.key);
        ASSERT_TRUE(row.base && row.base->radius) << info.key;
        EXPECT_NEAR(*row.base->radius, prime - 10e-3, 1e-9) << info.key;
        EXPECT_EQ(row.feasible, *row.base->radius <= 30e-3) << info.key;
        EXPECT_EQ(row.limits[0].kept, row.feasible) << info.key;
        ++seen;
    }
    EXPECT_GT(seen, 15);
    // The optimum needs no more than it has, and here all of it: the limit is active.
    EXPECT_NEAR(*row_of(comparison, "").base->radius, 30e-3, 1e-7);
}

TEST(Comparison, FlatFaceBaseRadiusMatchesDenseComputation) {
    const Comparison comparison =
        compare(scene_of("RR", 24)
                    // Breakpoints of the mirrored laws are rounded.
                    .with("motion = { type = 'RR', lift_mm = 10, rise_rad = 1.3, return_rad = 1.1 }",
                          "cam = { type = 'disk', follower = 'translating_flat', base_radius_mm = 80 }",
                          "limits.cam_radius_min_mm = 5"));
    for (const LawInfo& info : rises()) {
        const std::unique_ptr<Law> law = make_law(info.key);
        double base = 0.0;  // max of 5 mm − s − s'', every piece of the law with its own two ends
        const std::vector<double> points = law->breakpoints();
        for (const double angle : {1.3, 1.1}) {
            for (std::size_t piece = 0; piece + 1 < points.size(); ++piece) {
                for (int k = 0; k <= 20000; ++k) {
                    const double x = points[piece] + (points[piece + 1] - points[piece]) * k / 20000;
                    const MotionPoint point =
                        law->at(k == 20000 ? points[piece + 1] : x, k == 20000 ? Side::left : Side::right);
                    base = std::max(
                        base, 5e-3 - 10e-3 * (point.derivative[0] + point.derivative[2] / (angle * angle)));
                }
            }
        }
        const ComparisonRow& row = row_of(comparison, info.key);
        ASSERT_TRUE(row.base && row.base->radius) << info.key;
        EXPECT_NEAR(*row.base->radius, base, 1e-9) << info.key;
    }
}

TEST(LawMotion, OneSidedValuesAtJumps) {
    MotionSpec motion;
    motion.type = MotionType::rr;
    motion.rise = 1.3;
    for (const double back : {0.37, 0.7, 1.1, 1.9}) {
        motion.return_angle = back;
        const LawMotion placed = law_motion(strokes_of(motion), false, make_law("parabolic"));
        const double ratio = motion.length() - 1.0, half = placed.motion->breakpoints()[3];
        EXPECT_NEAR(half, 1.0 + 0.5 * ratio, 1e-15);
        EXPECT_NEAR(placed.motion->at(half, Side::left).derivative[2], -4.0 / (ratio * ratio), 1e-10);
        EXPECT_NEAR(placed.motion->at(half, Side::right).derivative[2], 4.0 / (ratio * ratio), 1e-10);
        EXPECT_EQ(placed.motion->breakpoints().back(), motion.length());
        EXPECT_NEAR(placed.peaks.acceleration.value, 4.0 / std::min(1.0, ratio * ratio), 1e-10);
    }
}

TEST(Comparison, RadiusIndependentLimitNeedsNoBaseRadius) {
    const Comparison comparison = compare(pressure_scene(40).with("limits.velocity = 1.9"));
    const ComparisonRow& cycloidal = row_of(comparison, "cycloidal");
    EXPECT_FALSE(cycloidal.base->radius);
    EXPECT_EQ(cycloidal.base->broken, "limits.velocity");
    EXPECT_TRUE(row_of(comparison, "modified_sine").base->radius);
}

TEST(Comparison, VariableBaseRadiusIsOptimalForAll) {
    const Comparison comparison = compare(pressure_scene(30).with(
        "cam.base_radius_mm = { min = 20, max = 60 }", "objective.base_radius = 0.5"));
    ASSERT_TRUE(comparison.cam);
    const double base = comparison.cam->formulas->base_radius(comparison.cam->dimensions).value();
    EXPECT_NEAR(row_of(comparison, "modified_sine").objective, 1.0 + 0.5 * base / 20e-3, 1e-9);
    EXPECT_NEAR(row_of(comparison, "").base->radius.value_or(0.0), base, 1e-6);
}

TEST(Comparison, RiseAndReturnAcceptsTurningPointLaws) {
    const Comparison comparison = compare(scene_of("RR", 24));
    for (const LawInfo& law : rises()) {
        const ComparisonRow& row = row_of(comparison, law.key);
        ASSERT_TRUE(row.motion) << law.key;
        EXPECT_GE(row.objective, comparison.optimum.any_curve_limit->objective * (1.0 - 1e-9)) << law.key;
    }
    const Peaks own = make_law("double_harmonic")->peaks();
    const ComparisonRow& row = row_of(comparison, "double_harmonic");
    EXPECT_NEAR(row.peaks.jerk.value, own.jerk.value, 1e-9);
    EXPECT_NEAR(row.peaks.rms_jerk, own.rms_jerk, 1e-9);
    EXPECT_DOUBLE_EQ(row.motion->at(1.3).derivative[0], row.motion->at(0.7).derivative[0]);
}

TEST(Comparison, ShortReturnMakesJerkDiscontinuous) {
    const Comparison comparison =
        compare(scene_of("RR", 24).with("motion.rise_deg = 180", "motion.return_deg = 90"));
    const ComparisonRow& turning = row_of(comparison, "double_harmonic");
    EXPECT_TRUE(std::isinf(turning.peaks.jerk.value));
    EXPECT_EQ(turning.peaks.jerk.at, 1.0);
    EXPECT_NEAR(row_of(comparison, "cycloidal").peaks.jerk.value, 8 * 4 * pi * pi, 1e-9);
}

TEST(Comparison, NormalisesEachProgramStrokeSeparately) {
    const Comparison comparison = compare(program_scene());
    for (const LawInfo& law : rises()) {
        const ComparisonRow& row = row_of(comparison, law.key);
        EXPECT_EQ(row.misfit.empty(), law.top == TopEnd::dwell) << law.key;
        if (law.top != TopEnd::dwell) continue;
        const Peaks own = make_law(law.key)->peaks();
        EXPECT_NEAR(row.peaks.acceleration.value, own.acceleration.value, 1e-12) << law.key;
        EXPECT_EQ(std::isinf(row.peaks.jerk.value), std::isinf(own.jerk.value)) << law.key;
    }
    EXPECT_NEAR(row_of(comparison, "modified_sine").objective, 1.0, 1e-12);
}

TEST(Comparison, TwoSimpleHarmonicsHaveNoImpulse) {
    const Comparison comparison = compare(program_scene({spline(180, 1.0), spline(180, 0.0)}));
    const ComparisonRow& eccentric = row_of(comparison, "simple_harmonic");
    EXPECT_NEAR(eccentric.peaks.jerk.value, pi * pi * pi / 2, 1e-9);
    EXPECT_NEAR(eccentric.peaks.rms_jerk, pi * pi * pi / 2 / std::sqrt(2.0), 1e-9);
    EXPECT_TRUE(std::isinf(row_of(comparison, "parabolic").peaks.jerk.value));
    EXPECT_NE(row_of(comparison, "double_harmonic").misfit, "");
}

TEST(Comparison, TurningPointLawsFitProgramsBetweenDwells) {
    const Comparison comparison = compare(program_scene({dwell(180), spline(90, 1.0), spline(90, 0.0)}));
    const ComparisonRow& row = row_of(comparison, "double_harmonic");
    ASSERT_TRUE(row.motion);
    EXPECT_NEAR(row.peaks.jerk.value, make_law("double_harmonic")->peaks().jerk.value, 1e-9);
    EXPECT_NEAR(row.motion->at(4.0, Side::left).derivative[0], 0.0, 1e-15);
}

TEST(Comparison, AFreeDisplacementIsTheOptimums) {
    const Comparison comparison =
        compare(program_scene({dwell(90), spline(90, 1.0), spline(90), spline(90, 0.0)}));
    const double chosen = comparison.optimum.motion->at(2.0).derivative[0];
    EXPECT_NEAR(row_of(comparison, "cycloidal").motion->at(2.0).derivative[0], chosen, 1e-12);
}

TEST(Comparison, ZeroStrokeHasNoImpulseOrReversal) {
    constexpr double radian = 180.0 / pi;
    const Comparison comparison =
        compare(program_scene({dwell(radian), spline(1.7 * radian, 1.0), spline(1.7 * radian, 1.0 - 1e-11),
                               spline(360.0 - 4.4 * radian, 0.0)}));
    // The stroke's own displacement is what it is normalised by: A and J are the law's.
    EXPECT_NEAR(row_of(comparison, "cycloidal").peaks.jerk.value, 4 * pi * pi, 1e-4);
    EXPECT_NE(row_of(comparison, "double_harmonic").misfit, "");
}

TEST(Comparison, FreeDisplacementUnknownWithoutOptimum) {
    Scene scene = program_scene({dwell(90), spline(90, 1.0), spline(90), spline(90, 0.0)});
    scene.limits.velocity = normalised_limit("limits.velocity", 0.3);
    const Comparison comparison = compare(scene);
    EXPECT_EQ(comparison.rows.size(), rises().size());
    EXPECT_TRUE(row_of(comparison, "cycloidal").misfit.starts_with("the scene leaves a displacement"));
}

TEST(Comparison, ListsLawsWithoutOptimum) {
    const Comparison comparison = compare(scene_of("DRD", 12).with("limits.velocity = 0.9"));
    EXPECT_EQ(comparison.optimum.certificate.verdict, Verdict::infeasible);
    for (const LawInfo& law : rises()) {
        const ComparisonRow& row = row_of(comparison, law.key);
        EXPECT_FALSE(row.feasible) << law.key;
        EXPECT_FALSE(row.loss_percent) << law.key;
    }
    EXPECT_NEAR(row_of(comparison, "modified_sine").objective, 1.0, 1e-14);
}

}  // namespace comparison_test
}  // namespace camopt
