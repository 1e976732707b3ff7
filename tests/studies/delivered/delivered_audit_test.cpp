// SPDX-License-Identifier: MIT
// What is delivered is what is said of it: the objective by its definition from knots and coefficients, every
// condition, every limit, whatever way the motion was found.
#include "studies/delivered/delivered_audit.hpp"

#include "profiles/disk/disk_cam.hpp"
#include "splines/curve.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/independent_spline.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/counting_clock.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace camopt {
namespace delivered_audit_test {

using namespace testing_support;

/// sqrt(1/L ∫ (y^{(order)})² dx) by Simpson's rule on each piece: exact for the cubes and quintics here where
/// the integrand has degree 6 or less, and far below 1e-12 for it split into 8.
double root_mean_square(const SplineCurve& curve, int order) {
    const IndependentSpline spline(curve.knots(), curve.coefficients(), curve.degree());
    const std::vector<double>& points = curve.space().breakpoints();
    long double sum = 0.0L;
    constexpr int parts = 64;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const long double width = static_cast<long double>(points[i + 1]) - points[i];
        for (int k = 0; k < parts; ++k) {
            const long double h = width / parts, left = points[i] + k * h;
            const auto square = [&](long double x) {
                const long double value = spline.derivative(x, order);
                return value * value;
            };
            // Three places inside (Gauss): no side to choose at a breakpoint.
            const long double off = std::sqrt(0.6L) * h / 2, middle = left + h / 2;
            sum += h / 18 * (5 * square(middle - off) + 8 * square(middle) + 5 * square(middle + off));
        }
    }
    return static_cast<double>(std::sqrt(sum / (points.back() - points.front())));
}

Scene random_rms_scene(unsigned seed) {
    std::mt19937 engine(seed);
    const auto uniform = [&] { return static_cast<double>(engine()) / 4294967296.0; };
    Scene scene;
    scene.spline.degree = 5;
    scene.spline.continuity = 2 + static_cast<int>(engine() % 2);
    std::vector<double> points = {0.0};
    const int segments = 12 + static_cast<int>(engine() % 28);
    for (int i = 0; i < segments; ++i) points.push_back(points.back() + std::pow(uniform(), 2.0) + 0.02);
    for (double& point : points) point /= points.back();
    points.back() = 1.0;
    scene.spline.breakpoints = points;
    scene.objective.jerk = 0.2;
    scene.objective.rms_jerk = 7.2;
    return scene;
}

TEST(DeliveredObjective, MatchesCurveForRootMeanSquares) {
    int delivered = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const Scene scene = random_rms_scene(seed);
        const Solution solution = solve(scene);
        if (!solution.curve || solution.certificate.verdict == Verdict::failed) continue;
        ++delivered;
        const double expected =
            scene.objective.jerk * solution.peaks.jerk.value / solution.reference_peaks.jerk.value +
            scene.objective.rms_jerk * root_mean_square(*solution.curve, 3) /
                solution.reference_peaks.rms_jerk;
        EXPECT_NEAR(solution.certificate.objective, expected, 1e-8 * expected) << "seed " << seed;
    }
    EXPECT_EQ(delivered, 12);
}

TEST(DeliveredAudit, WideGapIsNotOptimal) {
    Solution solution = solved(scene_named("drd_cubic_12"));
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);
    solution.scene.solver.gap = 1e-12;
    solution.certificate.lower_bound = *solution.certificate.lower_bound - 1e-6;
    audit_delivered(solution);
    EXPECT_EQ(solution.certificate.verdict, Verdict::local);
    EXPECT_EQ(solution.certificate.reason, Reason::stationary);
    EXPECT_TRUE(solution.certificate.lower_bound);
}

void expect_failed(Solution solution, const char* reason) {
    audit_delivered(solution);
    EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
    EXPECT_EQ(solution.certificate.reason, reason);
    EXPECT_FALSE(solution.certificate.lower_bound);
    EXPECT_FALSE(solution.certificate.gap);
    EXPECT_FALSE(solution.certificate.proof);
    ASSERT_FALSE(solution.notes.empty());
}

TEST(DeliveredAudit, LeavesATrueVerdictAlone) {
    Solution solution = solved(scene_named("drd_cubic_12"));
    const double objective = solution.certificate.objective;
    audit_delivered(solution);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_EQ(solution.certificate.objective, objective);
    EXPECT_TRUE(solution.certificate.proof);
}

TEST(DeliveredAudit, FalseObjectiveIsCorrectedWithoutVerdict) {
    Solution solution = solved(scene_named("drd_cubic_12"));
    const double objective = solution.certificate.objective;
    solution.certificate.objective *= 1.0 - 1e-6;
    expect_failed(solution, "objective_not_of_the_curve");
    audit_delivered(solution);
    EXPECT_NEAR(solution.certificate.objective, objective, 1e-12);
}

TEST(DeliveredAudit, ViolatedLimitEndsVerdict) {
    Solution solution = solved(scene_named("drd_cubic_12"));
    ConstraintReport velocity{"velocity", "limits.velocity", 1.7, 1.7 * (1.0 + 1e-9), "", 0.5, true};
    solution.constraints = {velocity};
    audit_delivered(solution);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    solution.constraints[0].worst = 1.7 * (1.0 + 1e-7);
    expect_failed(solution, "limit_not_kept");
    solution.constraints[0].worst = std::nan("");
    expect_failed(solution, "limit_not_kept");
}

TEST(DeliveredAudit, EveryConditionIsChecked) {
    const Solution& solution = solved(scene_named("drd_cubic_12"));
    const auto with = [&](auto change) {
        Solution changed = solution;
        change(changed.scene);
        return changed;
    };
    expect_failed(with([](Scene& scene) { scene.motion.type = MotionType::rr; }), "condition_not_met");
    expect_failed(with([](Scene& scene) {
                      scene.motion.via = {{0.5, 0.5, {}, {}}, {0.5, {}, 1.0, {}}};
                  }),
                  "condition_not_met");
    expect_failed(with([](Scene& scene) { scene.motion.via = {{0.25, {}, {}, 0.0}}; }), "condition_not_met");
    expect_failed(with([](Scene& scene) { scene.spline.rest = 3; }), "condition_not_met");
    Solution bent =
        solve(scene_named("drd_cubic_12").with("motion.via = [{ at = 0.5, displacement = 0.6 }]"));
    ASSERT_EQ(bent.certificate.verdict, Verdict::optimal);
    bent.scene.motion.symmetric = true;
    expect_failed(bent, "condition_not_met");
}

TEST(DeliveredAudit, ProgramsAreChecked) {
    Solution solution = solve(program({dwell(60), spline(120, 1.0), dwell(60), spline(120, 0.0)}));
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_TRUE(missed_conditions(solution, 1e-10).empty());
    Solution elsewhere = solution;
    elsewhere.scene.motion.segments[1].to = 0.9;
    expect_failed(elsewhere, "condition_not_met");
    // A spline where there was a dwell: it may pass its ends at speed, but then y''' is shared as well.
    Solution open = solution;
    open.scene.motion.segments[3].to = 0.1;
    EXPECT_GT(missed_conditions(open, 1e-10).at(0).relative, 0.05);
}

TEST(DeliveredAudit, SmoothJointsDoNotJump) {
    // y'' of two mirrored quintics is 0 at 0, 1/2 and 1: what is left there is rounding, and no measure of
    // itself.
    for (const DesignKind kind : {DesignKind::states, DesignKind::coefficients, DesignKind::ordinates}) {
        for (const int continuity : {2, 4}) {
            if (kind == DesignKind::ordinates && continuity < 4) continue;
            Scene scene = paper_objective(MotionType::drd, 5, 2);
            scene.spline.continuity = continuity;
            scene.spline.design = kind;
            EXPECT_EQ(solve(scene).certificate.verdict, Verdict::optimal) << name_of(kind) << continuity;
            scene.motion.symmetric = true;
            EXPECT_EQ(solve(scene).certificate.verdict, Verdict::optimal) << name_of(kind) << continuity;
        }
    }
}

TEST(DeliveredAudit, RelaxationWithMarginFindsMotion) {
    Scene scene = paper_objective(MotionType::rr, 5, 2);
    scene.motion.symmetric = true;
    scene.limits.acceleration = normalised_limit("limits.acceleration", 5.5);
    const Solution without = solve(scene);
    ASSERT_EQ(without.certificate.verdict, Verdict::infeasible);
    // Beside the cap stands only how many segments would do.
    const auto row = std::ranges::find(without.relaxation, "limits.acceleration", &Relaxation::key);
    ASSERT_TRUE(row != without.relaxation.end() && row->needed);
    for (const Relaxation& other : without.relaxation)
        EXPECT_TRUE(other.key == row->key || other.key == "spline.segments") << other.key;
    EXPECT_NEAR(*row->needed, 20.0 / 3.0, 1e-6);
    scene.limits.acceleration = normalised_limit("limits.acceleration", *row->needed * (1.0 + 1e-6));
    EXPECT_EQ(solve(scene).certificate.verdict, Verdict::optimal);
}

/// The last run, which may end where it likes, stands: what rounding leaves there is no measure of itself.
TEST(DeliveredAudit, StationaryRunIsScaledByMotion) {
    const Solution solution = solve(scene_named("last_run_stands"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    ASSERT_FALSE(solution.segments.empty());
    const SegmentReport& last = solution.segments.back();
    ASSERT_TRUE(last.curve);
    EXPECT_LT(std::abs(last.to - last.from), 1e-6);
    EXPECT_EQ(worst_joint_jump(*last.curve).relative, 0.0);
    Eigen::MatrixXd pieces = last.curve->pieces();
    pieces(2, 1) += 1e-13;
    const SplineCurve rounded(last.curve->space(), pieces);
    EXPECT_LE(worst_joint_jump(rounded, solution.motion_peaks).relative, largest_joint_jump);
    // By itself it is no motion at all.
    EXPECT_GT(worst_joint_jump(rounded).relative, largest_joint_jump);
}

/// A flat face on an arm, whose Hertz pressure grows without end where the cam comes to a cusp.
Scene pressed_flat_arm() {
    Scene scene;
    scene.motion.type = MotionType::rr;
    scene.motion.lift_is_angle = true;
    scene.motion.lift = 0.30657301390103203;
    scene.motion.rise = 1.3915954128223365;
    scene.motion.speed = 59.485315191468317;
    scene.spline.segments = 16;
    scene.objective.velocity = 0.31363388334334169;
    scene.objective.acceleration = 0.8194988418231377;
    scene.objective.jerk = 0.428741647420322;
    scene.cam = disk_spec({.follower = FollowerType::oscillating_flat});
    scene.cam->rotation = Rotation::clockwise;
    scene.cam->set(DimensionIndex::base_radius, 0.060709346929363382);
    scene.cam->set(DimensionIndex::center_distance, 0.16772536077587732);
    scene.forces.emplace();
    scene.forces->mass = 0.027041736743809223;
    scene.forces->spring_rate = 365.45022010326585;
    scene.forces->preload = 102.79610434173111;
    scene.forces->contact_width = 0.01;
    scene.limits.hertz_pressure_max =
        WrittenLimit{2365402820.3055606, "limits.hertz_pressure_max_pa", 1.0, "Pa"};
    scene.solver.starts = 1;
    scene.solver.max_seconds = 2000.0;  // readings of a counting clock
    return scene;
}

TEST(DeliveredAudit, VerdictAllowsNoViolation) {
    const auto stands = [](const Solution& solution) {
        return has_feasible_motion(solution.certificate.verdict);
    };
    Scene scene = pressed_flat_arm();
    testing_support::CountingClock clock, another;
    const Solution none = solve(scene, clock.control());  // every motion that is found has a cusp
    EXPECT_FALSE(stands(none)) << name_of(none.certificate.verdict);
    EXPECT_FALSE(none.motion);
    scene.cam->set(DimensionIndex::base_radius, 0.07);
    const Solution solution = solve(scene, another.control());
    EXPECT_TRUE(stands(solution)) << name_of(solution.certificate.verdict);
    ASSERT_EQ(solution.constraints.size(), 1u);
    const double limit = solution.constraints[0].limit;
    EXPECT_LE(solution.constraints[0].worst, limit * (1.0 + 1e-8));
    EXPECT_GT(solution.constraints[0].worst, 0.999 * limit);
}

/// A cost is never negative. Numerically hard scenes have dual bounds far below: none is shown.
TEST(DeliveredAudit, NegativeBoundIsHidden) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const Certificate certificate = solve(random_rms_scene(seed)).certificate;
        if (certificate.verdict == Verdict::optimal || !certificate.lower_bound) continue;
        EXPECT_GE(*certificate.lower_bound, 0.0) << seed;
    }
    Certificate certificate;
    certificate.verdict = Verdict::feasible;
    certificate.lower_bound = -3.0;
    certificate.gap = 4.0;
    certificate.proof_kind = ProofKind::duality;
    ObjectiveSpec objective;
    objective.area = 1.0;  // may be negative
    drop_idle_bound(certificate, objective);
    EXPECT_EQ(certificate.lower_bound, -3.0);
    drop_idle_bound(certificate, {});
    EXPECT_FALSE(certificate.lower_bound || certificate.gap || certificate.proof);
    EXPECT_EQ(certificate.proof_kind, ProofKind::none);
}

/// The cost of a point that nobody gets is no objective.
TEST(DeliveredAudit, MissingMotionHasNoObjective) {
    const Solution solution = solve(scene_named("drd_cubic_12").with("limits.velocity = 0.9"));
    ASSERT_FALSE(solution.motion);
    EXPECT_FALSE(std::isfinite(solution.certificate.objective));
}

/// Pieces that do not meet are no one motion, and no figure of them is one of it: nothing is delivered.
TEST(DeliveredAudit, DisjointPiecesDeliverNoMotion) {
    Solution solution = solved(scene_named("drd_cubic_12"));
    Eigen::MatrixXd pieces = solution.curve->pieces();
    pieces(0, 5) += 1e-4;
    solution.curve = SplineCurve(solution.curve->space(), pieces);
    audit_delivered(solution);
    EXPECT_EQ(solution.certificate.verdict, Verdict::failed);
    EXPECT_EQ(solution.certificate.reason, Reason::breakpoints_too_close);
    EXPECT_FALSE(solution.motion || solution.curve || solution.cam);
    EXPECT_TRUE(solution.constraints.empty());
    EXPECT_FALSE(std::isfinite(solution.certificate.objective));
    ASSERT_FALSE(solution.notes.empty());
    EXPECT_NE(solution.notes.back().find("conditions nearly contradict"), std::string::npos);
}

}  // namespace delivered_audit_test
}  // namespace camopt
