// SPDX-License-Identifier: MIT
// Scenes whose cost is far from one, and the audit of what is delivered.
#include "objectives/scene_model.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/solve/solve.hpp"
#include "tests/soak/stability/stability_scenes.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace camopt::stability {
namespace stability_test {

Solution solved_twelve() {
    return solve(scene_of(study_scene(MotionType::drd, 3, 12)));
}

/// The solution with one number of its motion changed.
Solution with_bent_piece(Solution solution, int power, double by) {
    Eigen::MatrixXd pieces = solution.curve->pieces();
    pieces(power, 4) += by;
    solution.curve = SplineCurve(solution.curve->space(), pieces);
    return solution;
}

TEST(CostUnits, LeavesScenesNearOneAlone) {
    const Scene scene = scene_of(study_scene(MotionType::drd, 3, 12));
    EXPECT_TRUE(cost_units(scene, reference_peaks(scene)).are_its_own());
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
TEST(CostUnits, FarLiftsAndTimesAreProved) {
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
TEST(CostUnits, ShortRampsAreProved) {
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

TEST(CostUnits, ProofRefersToScene) {
    Scene scene = scene_of(study_scene(MotionType::drd, 3, 12));
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
    Solution solution = solved_twelve();
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
