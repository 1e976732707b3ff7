// SPDX-License-Identifier: MIT
// Laws of a program that depend on what is beside them: polynomials between states, laws that turn back at
// their top; laws with numbers of their own.
#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "report/json/result_json.hpp"
#include "report/json/result_reader.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/restored/restored_solution.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace segment_laws_test {

using namespace testing_support;

const TestScene shear = scene_named("flying_shear");
const TestScene turning = scene_named("one_dwell_laws");

std::string segments(std::string_view list) {
    return fmt::format("motion.segments = [{}]", list);
}

TEST(SegmentLaw, PolynomialTakesStatesOfNeighbours) {
    const Scene scene = shear;
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    const double unit = scene.motion.unit_angle() / units::degree;
    for (const double degrees : {70.0, 150.0, 210.0}) {
        const MotionPoint before = solution.motion->at(degrees / unit, Side::left),
                          after = solution.motion->at(degrees / unit, Side::right);
        for (std::size_t r = 0; r < 3; ++r)
            EXPECT_NEAR(before.derivative[r], after.derivative[r], 1e-9) << degrees << " deg, order " << r;
    }
    // -320 mm/s at 360 deg/s, in lifts by x.
    EXPECT_NEAR(solution.motion->at(210.0 / unit).derivative[1], -320.0 / 300.0 / 360.0 * unit, 1e-9);
    EXPECT_NEAR(solution.motion->at(0.0).derivative[2], 0.0, 1e-12);
}

TEST(SegmentLaw, PolynomialBetweenDwellsIs345) {
    const auto of = [](const char* law) {
        return solve(turning.with(segments(fmt::format(
            "{{ kind = 'law', law = '{}', angle_deg = 90, to = 1 }}, {{ kind = 'dwell', angle_deg = 90 }}, "
            "{{ kind = 'law', law = 'cycloidal', angle_deg = 90, to = 0 }}, {{ kind = 'dwell', angle_deg = "
            "90 }}",
            law))));
    };
    EXPECT_NEAR(of("polynomial").peaks.jerk.value, 60.0, 1e-9);
    EXPECT_NEAR(of("polynomial").peaks.jerk.value, of("polynomial_345").peaks.jerk.value, 1e-9);
}

TEST(SegmentLaw, TurningLawTurnsWithTheMotion) {
    const Scene scene = turning;
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    const Peaks own = make_law("double_harmonic")->peaks();
    EXPECT_NEAR(solution.peaks.velocity.value, own.velocity.value, 1e-12);
    EXPECT_NEAR(solution.peaks.acceleration.value, own.acceleration.value, 1e-12);
    EXPECT_NEAR(solution.peaks.jerk.value, own.jerk.value, 1e-9);
    for (int i = 0; i <= 100; ++i) {
        const double x = i / 100.0;
        EXPECT_NEAR(solution.motion->at(1.0 + x).derivative[0], solution.motion->at(1.0 - x).derivative[0],
                    1e-14);
    }
}

// The second derivative jumps at the top.
TEST(SegmentLaw, UnequalReturnHasInfiniteJerk) {
    const std::string unequal = segments(
        "{ kind = 'law', law = 'double_harmonic', angle_deg = 110, to = 1 }, { kind = 'law', law = "
        "'double_harmonic', angle_deg = 90, to = 0 }, { kind = 'dwell', angle_deg = 160 }");
    EXPECT_EQ(solve(turning.with(unequal, "solver.explain_seconds = 0.1")).certificate.verdict,
              Verdict::infeasible);
    const Solution solution = solve(turning.with(unequal, "limits = {}"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_TRUE(std::isinf(solution.peaks.jerk.value));
    EXPECT_EQ(
        refusal([&] { (void)solve(turning.with(unequal, "limits = {}", "objective.jerk = 1")); }),
        "objective.jerk: found 1 with the law \"double_harmonic\", which has no finite jerk; allowed: 0, or "
        "another law");
}

TEST(SegmentLaw, TurningLawIsRefusedAtDwells) {
    const std::string message = refusal([] {
        (void)solve(turning.with(
            segments("{ kind = 'law', law = 'double_harmonic', angle_deg = 180, to = 1 }, "
                     "{ kind = 'dwell', angle_deg = 90 }, { kind = 'law', law = "
                     "'cycloidal', angle_deg = 60, to = 0 }, { kind = 'dwell', angle_deg = 30 }")));
    });
    EXPECT_EQ(
        message,
        "motion.segments[0].law: found \"double_harmonic\", a law that turns back at its top, where this "
        "motion does not turn; allowed: a law that ends at rest; this one where the motion turns back at "
        "once at one end of the segment");
}

TEST(SegmentLaw, PolynomialNeedsARise) {
    const std::string message = refusal(
        [] { (void)solve(shear.with("motion.segments[0].to_mm = 0", "motion.segments[1].to_mm = 180")); });
    EXPECT_EQ(message,
              "motion.segments[0].law: found \"polynomial\", that ends at the displacement where it "
              "begins; allowed: another displacement; a spline makes a motion without a rise");
}

TEST(SegmentLaw, OwnNumbersAreReadAgain) {
    const std::string law = segments(
        "{ kind = 'law', law = 'modified_sine(Ta = 0.20)', angle_deg = 110, to = 1 }, { kind = 'law', law "
        "= 'scca(1, 2, 1, 0.5)', angle_deg = 110, to = 0 }, { kind = 'dwell', angle_deg = 140 }");
    const Scene scene = turning.with(law, "limits = {}");
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(solution.segments[0].peaks->jerk.value,
                make_law("modified_sine", std::array{0.2})->peaks().jerk.value, 1e-9);
    const std::string result = result_json(solution);
    EXPECT_NE(result.find("\"modified_sine(0.2)\""), std::string::npos);
    const Solution again =
        restored_solution(scene, read_result(result, "result.json", [&]() -> const Scene& { return scene; }));
    EXPECT_EQ(again.peaks.jerk.value, solution.peaks.jerk.value);
}

TEST(SegmentLaw, NumbersOutOfRangeAreRefused) {
    const std::string message = refusal([] {
        (void)turning.with(segments("{ kind = 'law', law = 'modified_sine(0.3)', angle_deg = 360, to = 0 }"))
            .read();
    });
    EXPECT_NE(
        message.find("found \"modified_sine(0.3)\"; allowed: numbers of this law: modified_sine: Ta = 0.3 "
                     "found, allowed 1e-09 <= Ta <= 0.25"),
        std::string::npos)
        << message;
}

/// Rest laws do not begin with the axis' speed; the polynomial of both ends does.
TEST(SegmentLaw, PolynomialIsComparedBetweenMovingEnds) {
    const Comparison comparison = compare(scene_named("49_moving_start").with("limits = {}"));
    ASSERT_TRUE(comparison.optimum.motion);
    int polynomials = 0;
    for (const ComparisonRow& row : comparison.rows) {
        if (row.key != "polynomial") continue;
        ++polynomials;
        ASSERT_TRUE(row.motion);
        EXPECT_NEAR(row.motion->at(0.0).derivative[1], comparison.optimum.motion->at(0.0).derivative[1],
                    1e-9);
        ASSERT_TRUE(row.loss_percent);
        EXPECT_GE(*row.loss_percent, 0.0);
    }
    EXPECT_EQ(polynomials, 1);
}

}  // namespace segment_laws_test
}  // namespace camopt
