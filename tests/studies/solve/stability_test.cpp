// SPDX-License-Identifier: MIT
// The quick rows of the stability table, group by group, and the judge of the table itself: it must see what
// is wrong.
#include "benchmarks/stability/condition_number.hpp"
#include "benchmarks/stability/local_polynomial.hpp"
#include "benchmarks/stability/motion_audit.hpp"
#include "benchmarks/stability/stability_cases.hpp"
#include "benchmarks/stability/stability_scenes.hpp"
#include "core/errors.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/search/cost_scale.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/solved_scene.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace camopt::stability {
namespace stability_test {

struct Group {
    const char* name;
    std::vector<StabilityCase> (*cases)();
};

class StabilityGroup : public testing::TestWithParam<Group> {};

TEST_P(StabilityGroup, HasNoWrongVerdict) {
    int run = 0;
    int absent = 0;
    for (const StabilityCase& one : GetParam().cases()) {
        if (!one.quick) continue;
        const StabilityRow row = one.run();
        ++(row.judgement == Judgement::absent ? absent : run);
        EXPECT_NE(row.judgement, Judgement::wrong)
            << row.group << ": " << row.name << ", " << row.backend << ": " << row.why;
        if (row.backend == "structured" && !row.expected.may_give_up) {
            EXPECT_EQ(row.judgement, Judgement::ok) << row.name << ": " << row.why;
        }
    }
    EXPECT_GT(run, 0);
    RecordProperty("rows_of_absent_backends", absent);
}

INSTANTIATE_TEST_SUITE_P(Table, StabilityGroup,
                         testing::Values(Group{"design_vectors", design_vector_cases},
                                         Group{"scaling", scaling_cases}, Group{"weights", weight_cases},
                                         Group{"breakpoints", breakpoint_cases},
                                         Group{"exact_points", exact_point_cases},
                                         Group{"limits", limit_cases}, Group{"degenerate", degenerate_cases},
                                         Group{"claims", claim_cases}, Group{"stiff_trains", train_cases}),
                         [](const auto& group) { return std::string(group.param.name); });

/// The solution with one number of its motion changed.
Solution with_bent_piece(Solution solution, int power, double by) {
    Eigen::MatrixXd pieces = solution.curve->pieces();
    pieces(power, 4) += by;
    solution.curve = SplineCurve(solution.curve->space(), pieces);
    return solution;
}

TEST(MotionAudit, FindsWhatTheLibraryReports) {
    const Solution solution = testing_support::solved(testing_support::scene_named("drd_cubic_12"));
    const MotionAudit report = audit(solution);
    EXPECT_NEAR(static_cast<double>(report.velocity), 12.0 / 7, 1e-8);
    EXPECT_NEAR(static_cast<double>(report.acceleration), 36.0 / 7, 1e-8);
    EXPECT_NEAR(static_cast<double>(report.jerk), 432.0 / 7, 1e-7);
    EXPECT_NEAR(static_cast<double>(report.objective), solution.certificate.objective, 1e-13);
    EXPECT_LE(report.violation, 1e-12L);
}

TEST(MotionAudit, SeesAJumpOfEveryOrder) {
    const Solution solution = testing_support::solved(testing_support::scene_named("drd_cubic_12"));
    for (int power = 0; power <= 2; ++power)
        EXPECT_GT(audit(with_bent_piece(solution, power, 1e-6)).violation, 1e-8L) << power;
}

TEST(MotionAudit, FindsViolatedConditions) {
    Solution capped = testing_support::solved(testing_support::scene_named("drd_cubic_12"));
    capped.scene.limits.velocity = PeakLimit{1.5, "limits.velocity", 1.5, ""};
    EXPECT_NEAR(static_cast<double>(audit(capped).violation), 12.0 / 7 / 1.5 - 1.0, 1e-8);
    Solution missed = testing_support::solved(testing_support::scene_named("drd_cubic_12"));
    missed.scene.motion.via = {{0.25, 0.9, {}, {}}};
    EXPECT_GT(audit(missed).violation, 0.1L);
    EXPECT_THROW(static_cast<void>(audit(Solution{})), InputError);
}

TEST(MotionAudit, FindsViolatedPressureAngle) {
    Solution solution = solve(scene_of_file("cam_smallest.toml"));
    EXPECT_LE(audit(solution).violation, 1e-9L);
    solution.scene.limits.pressure_angle->value *= 0.99;
    EXPECT_GT(audit(solution).violation, 5e-3L);
}

TEST(StabilityRow, CallsAFalseFigureWrong) {
    const Scene scene = study_scene(MotionType::drd, 3, 12);
    const double optimum = study_objective(12.0 / 7, 36.0 / 7, 432.0 / 7);
    EXPECT_EQ(solved_row(scene, exactly(optimum, "")).judgement, Judgement::ok);
    EXPECT_EQ(solved_row(scene, exactly(optimum * (1.0 - 1e-7), "")).judgement, Judgement::wrong);
    EXPECT_EQ(solved_row(scene, exactly(optimum * (1.0 + 1e-7), "")).judgement, Judgement::wrong);
    Expectation impossible;
    impossible.verdicts = {Verdict::infeasible};
    EXPECT_EQ(solved_row(scene, impossible).judgement, Judgement::wrong);
    EXPECT_EQ(refused_row([] {}, "").judgement, Judgement::wrong);
}

TEST(LocalPolynomial, FindsRootsAndPeaks) {
    // (u − 1/4)(u − 1/2)(u − 3/4)
    const LocalPolynomial cubic = {-3.0L / 32, 11.0L / 16, -1.5L, 1.0L};
    const std::vector<long double> roots = sign_changes(cubic);
    ASSERT_EQ(roots.size(), 3u);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(static_cast<double>(roots[k]), 0.25 * (k + 1), 1e-15);
    EXPECT_NEAR(static_cast<double>(largest_magnitude(cubic)), 3.0 / 32, 1e-18);
    EXPECT_NEAR(static_cast<double>(largest_magnitude({0.0L, 4.0L, -4.0L})), 1.0, 1e-15);
}

TEST(ConditionNumber, GrowsSlowestForStates) {
    for (const int order : {2, 3}) {
        const Scene scene = study_scene(MotionType::drd, 3, 32);
        const double states = condition_number(scene, DesignKind::states, order);
        EXPECT_GT(states, 1.0);
        EXPECT_LT(10.0 * states, condition_number(scene, DesignKind::ordinates, order));
        EXPECT_LT(2.0 * states, condition_number(scene, DesignKind::coefficients, order));
    }
    // One freedom: every map is a column, and perfectly conditioned.
    EXPECT_NEAR(condition_number(study_scene(MotionType::drd, 3, 4), DesignKind::ordinates, 2), 1.0, 1e-12);
}

TEST(CostScale, LeavesScenesNearOneAlone) {
    const Scene scene = study_scene(MotionType::drd, 3, 12);
    EXPECT_TRUE(
        CostScale(scene,
                  testing_support::solved(testing_support::scene_named("drd_cubic_12")).reference_peaks)
            .is_idle());
}

/// A rise in five segments: two of length b, the cruise, two of length b, that may be no faster than 1 / (1 −
/// 2.5 b). Least jerk: J, then −J + d, and in the cruise an acceleration from d b to −d b that lets it reach
/// that velocity in the middle. With m = 1 − 4 b, velocity and lift are
///   J b² + d (b²/2 + b m/4) = V,   2 b³ (J + d/6) + m (J b² + d b²/2 + d b m/6) = 1.
struct LongCruise {
    double lift_mm, seconds, ramp;

    [[nodiscard]] double velocity() const { return 1.0 / (1.0 - 2.5 * ramp); }
    [[nodiscard]] double jerk() const {
        const double b = ramp, m = 1.0 - 4.0 * b;
        Eigen::Matrix2d rows;
        rows << b * b, b * (b / 2 + m / 4), b * b * (2 * b + m), b * (b * b / 3 + m * (b / 2 + m / 6));
        return rows.inverse().row(0).dot(Eigen::RowVector2d(velocity(), 1.0));
    }
    /// With limits on acceleration and jerk that many times, and its square, as large as needed.
    [[nodiscard]] Scene scene(double loose) const {
        const double b = ramp, speed = lift_mm / seconds;
        return scene_of_text(fmt::format(
            "[motion]\ntype = \"DRD\"\nlift_mm = {}\nrise_deg = 360\nspeed_rad_s = {}\n[spline]\n"
            "breakpoints = [0, {}, {}, {}, {}, 1]\n[objective]\njerk = 1\n[limits]\nvelocity_mm_s = {}\n"
            "acceleration_mm_s2 = {}\njerk_mm_s3 = {}\n[solver]\nname = \"structured\"\n",
            lift_mm, 2.0 * std::numbers::pi / seconds, b, 2 * b, 1 - 2 * b, 1 - b, velocity() * speed,
            loose * jerk() * b * speed / seconds, loose * loose * jerk() * speed / seconds / seconds));
    }
};

/// Lifts from a micrometre to ten metres, times from a millisecond to hours, ramps down to a hundred
/// thousandth of the time, for any limits.
TEST(CostScale, FarLiftsAndTimesAreProved) {
    for (const double lift : {1e-3, 1.0, 1e4})
        for (const double seconds : {1e-3, 1.0, 1e4})
            for (const double ramp : {0.1, 1e-3, 1e-5})
                for (const double loose : {1.25, 1e5}) {
                    const LongCruise one{lift, seconds, ramp};
                    const Solution solution = solve(one.scene(loose));
                    const double objective = one.jerk() / solution.reference_peaks.jerk.value;
                    SCOPED_TRACE(
                        fmt::format("{} mm in {} s, ramps {}, limits times {}", lift, seconds, ramp, loose));
                    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
                    EXPECT_NEAR(solution.certificate.objective / objective, 1.0, 1e-7);
                }
}

/// 7599 mm at 1 mm/s in 7601.5 s, ramps of a second, alone and in a program: the optimum that Ipopt proves.
TEST(CostScale, ShortRampsAreProved) {
    const LongCruise one{7599.0, 7601.5, 1.0 / 7601.5};
    EXPECT_NEAR(one.velocity() * one.lift_mm / one.seconds, 1.0, 1e-12);
    const Scene rise = one.scene(1.0003);
    Scene program = rise;
    program.motion.type = MotionType::program;
    const double quarter = 0.5 * std::numbers::pi;
    for (const double to : {1.0, 0.0}) {
        program.motion.segments.push_back({SegmentKind::dwell, quarter, "", {}});
        program.motion.segments.push_back({SegmentKind::spline, quarter, "", to});
    }
    *program.motion.speed /= 4.0;
    for (const Scene& scene : {rise, program}) {
        const Solution solution = solve(scene);
        EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
        EXPECT_NEAR(solution.certificate.objective, 831919.3420583, 1e-2);
    }
}

TEST(CostScale, ProofRefersToScene) {
    Scene scene = study_scene(MotionType::drd, 3, 12);
    scene.objective.velocity *= 1e-9;
    scene.objective.acceleration *= 1e-9;
    scene.objective.jerk *= 1e-9;
    const Solution solution = solve(scene);
    const Certificate& certificate = solution.certificate;
    const double optimum = 1e-9 * study_objective(12.0 / 7, 36.0 / 7, 432.0 / 7);
    ASSERT_EQ(certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(certificate.objective, optimum, 1e-9 * optimum);
    ASSERT_TRUE(certificate.proof);
    EXPECT_EQ(recomputed_bound(*certificate.proof), *certificate.lower_bound);
    EXPECT_NEAR(*certificate.lower_bound, optimum, 1e-7 * optimum);
    EXPECT_NEAR(solution.any_curve_limit->objective, 0.9371963699e-9, 1e-18);
    EXPECT_EQ(solution.scene.objective.velocity, scene.objective.velocity);
}

TEST(DeliveredAudit, JumpIsNamedFailure) {
    Solution solution = testing_support::solved(testing_support::scene_named("drd_cubic_12"));
    audit_delivered(solution);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    Solution bent = with_bent_piece(solution, 1, 1e-4);
    EXPECT_NEAR(worst_joint_jump(*bent.curve).at, 4.0 / 12, 1e-12);
    EXPECT_EQ(worst_joint_jump(*bent.curve).order, 1);
    audit_delivered(bent);
    EXPECT_EQ(bent.certificate.verdict, Verdict::failed);
    EXPECT_EQ(bent.certificate.reason, "breakpoints_too_close");
    ASSERT_FALSE(bent.notes.empty());
}

}  // namespace stability_test
}  // namespace camopt::stability
