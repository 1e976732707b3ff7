// SPDX-License-Identifier: MIT
// Programs of laws and dwells: there is one motion, and only the cam may have something to choose; loads over
// the cam angle on it.
#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "studies/search/plan.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/solved_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace camopt {
namespace prescribed_motion_test {

using namespace testing_support;

const TestScene program = scene_named("prescribed_laws");
constexpr const char* roller =
    "cam = { type = 'disk', follower = 'translating_roller', base_radius_mm = 40, roller_radius_mm = 10 }";

TEST(PrescribedMotion, NeedsNeitherSplineNorObjective) {
    const Scene scene = program;
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    EXPECT_EQ(solution.certificate.objective, 0.0);
    EXPECT_NE(plan(scene).reason.find("nothing to optimize"), std::string::npos);
    const double half = 45.0 * units::degree;  // the cycloidal rise at its middle, where y' = 2
    EXPECT_NEAR(solution.motion->at(half / scene.motion.unit_angle()).derivative[1], 2.0, 1e-9);
    EXPECT_NEAR(solution.peaks.velocity.value, 2.0, 1e-12);
    EXPECT_NEAR(solution.peaks.acceleration.value, make_law("cycloidal")->peaks().acceleration.value, 1e-12);
    EXPECT_EQ(solution.segments.size(), 4U);
}

TEST(PrescribedMotion, ViolatedLimitIsInfeasible) {
    for (const char* limit : {"limits.velocity = 1.9", "limits.acceleration_m_s2 = 20",
                              "limits.acceleration_m_s2 = { min = -20 }"}) {
        SCOPED_TRACE(limit);
        const Solution solution = solve(program.with(limit, "solver.explain_seconds = 0.5"));
        EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
        ASSERT_FALSE(solution.conflict.empty());
        EXPECT_TRUE(solution.conflict.front().key.starts_with("limits."));
        ASSERT_FALSE(solution.relaxation.empty());
        EXPECT_TRUE(solution.relaxation.front().needed);
    }
    EXPECT_EQ(solve(program.with("limits.velocity = 2.1")).certificate.verdict, Verdict::optimal);
    const Solution solution =
        solve(scene_named("flat_all_laws").with("limits.jerk = 80", "solver.explain_seconds = 0.1"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible)
        << "the jerk of a simple harmonic is infinite";
    EXPECT_EQ(solution.conflict.at(0).key, "limits.jerk");
}

// Two simple harmonics that join into a full sine have J = π³ / 2 = 15.503.
TEST(PrescribedMotion, JerkLimitHoldsAcrossSmoothJoints) {
    const auto eccentric = [](const char* limit) {
        return solve(program.with(
            "motion.segments = [{ kind = 'law', law = 'simple_harmonic', angle_deg = 180, to = 1 },"
            "{ kind = 'law', law = 'simple_harmonic', angle_deg = 180, to = 0 }]",
            limit));
    };
    EXPECT_EQ(eccentric("limits.jerk = 15.51").certificate.verdict, Verdict::optimal);
    EXPECT_EQ(eccentric("limits.jerk = 15.49").certificate.verdict, Verdict::infeasible);
}

TEST(PrescribedMotion, HasACamWithItsLimits) {
    const Solution solution = solve(program.with(roller, "limits.pressure_angle_deg = 40"));
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    ASSERT_TRUE(solution.cam);
    EXPECT_GT(solution.cam->summary.pressure_angle.value, 10.0 * units::degree);
    const Solution broken = solve(program.with(roller, "limits.pressure_angle_deg = 10"));
    EXPECT_EQ(broken.certificate.verdict, Verdict::infeasible);
    const auto base = std::ranges::find(broken.relaxation, "cam.base_radius_mm", &Relaxation::key);
    ASSERT_NE(base, broken.relaxation.end());
    EXPECT_GT(base->needed.value(), 40.0);
}

/// The smallest flat-face cam without undercut: base = max −(s + s''), here on a dense grid.
TEST(PrescribedMotion, SmallestBaseCircleIsFound) {
    const Scene scene = scene_named("flat_all_laws");
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    const double angle = scene.motion.unit_angle(), lift = scene.motion.lift;
    double needed = 0.0;
    constexpr int places = 200000;
    for (int k = 0; k <= places; ++k) {
        const MotionPoint at =
            solution.motion->at(solution.motion->end() * k / places, k < places ? Side::right : Side::left);
        needed = std::max(needed, -lift * (at.derivative[0] + at.derivative[2] / (angle * angle)));
    }
    EXPECT_NEAR(solution.cam->cam.dimensions[0], needed, 1e-8);
}

TEST(PrescribedMotion, LawsSayWhereTheyEnd) {
    const std::string message = refusal([] {
        (void)program
            .with(
                "motion.segments = [{ kind = 'law', law = 'cycloidal', angle_deg = 180, to = 1 },"
                "{ kind = 'law', law = 'cycloidal', angle_deg = 180 }]")
            .read();
    });
    EXPECT_NE(message.find("motion.segments[1].to"), std::string::npos) << message;
}

TestScene with_forces(const TestScene& scene, const char* load) {
    return scene.with(roller,
                      "forces = { mass_kg = 0.8, spring_rate_n_mm = 4, preload_n = 120, damping_n_s_m = 30, "
                      "contact_width_mm = 12 }",
                      load);
}

/// By the formula of the manual, at every angle.
TEST(ForceLoad, CountsInForceTorqueAndPressure) {
    const Scene scene = with_forces(program, "forces.load_n = [[0, 0], [80, 400], [150, 100], [300, 50]]");
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.cam && solution.cam->summary.forces);
    const double angle = scene.motion.unit_angle(), lift = scene.motion.lift, speed = *scene.motion.speed;
    const auto load = [](double deg) {
        if (deg < 80.0) return 400.0 * deg / 80.0;
        if (deg < 150.0) return 400.0 - 300.0 * (deg - 80.0) / 70.0;
        if (deg < 300.0) return 100.0 - 50.0 * (deg - 150.0) / 150.0;
        return 50.0 - 50.0 * (deg - 300.0) / 60.0;
    };
    double least = 1e9, largest = -1e9, torque = 0.0;
    constexpr int places = 36000;
    for (int k = 0; k < places; ++k) {
        const double theta = units::turn * (k + 0.5) / places;
        const MotionPoint at = solution.motion->at(theta / angle);
        const double s = lift * at.derivative[0], v = lift / angle * at.derivative[1],
                     a = lift / angle / angle * at.derivative[2];
        const double force =
            0.8 * speed * speed * a + 30.0 * speed * v + 4000.0 * s + 120.0 + load(theta / units::degree);
        least = std::min(least, force);
        largest = std::max(largest, force);
        torque = std::max(torque, std::abs(force * v));
    }
    const ForceSummary& summary = *solution.cam->summary.forces;
    EXPECT_NEAR(summary.least_force.value, least, 0.05);  // of the grid
    EXPECT_NEAR(summary.largest_force.value, largest, 0.05);
    EXPECT_NEAR(summary.torque.value, torque, 1e-3);
}

TEST(ForceLoad, LimitsHoldWithIt) {
    const TestScene splines(
        "motion = { type = 'RR', lift_mm = 12, rise_deg = 110, speed_rpm = 400 }\n"
        "spline = { degree = 5, segments = 16 }\nobjective.acceleration = 1\nsolver.starts = 1\n");
    Scene scene = with_forces(splines, "forces.load_n = [[0, 100], [60, -150], [150, -120], [220, 200]]")
                      .with("limits.contact_force_min_n = 20");
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.motion) << solution.certificate.reason;
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    EXPECT_GE(solution.cam->summary.forces->least_force.value, 20.0 * (1.0 - 1e-6));
    scene.forces->load.clear();
    EXPECT_LT(solve(scene).certificate.objective, solution.certificate.objective - 1e-6)
        << "the load costs nothing";
}

TEST(RoundTappet, ContactStaysOnTheChord) {
    const Scene scene = TestScene(
        "motion = { type = 'RR', lift_mm = 8, rise_deg = 60, speed_rpm = 500 }\nspline.segments = 16\n"
        "cam = { type = 'disk', follower = 'translating_flat', base_radius_mm = 30, face_radius_mm = 15 }\n"
        "forces = { contact_width_mm = 14, preload_n = 100 }\nobjective.jerk = 1\n");
    EXPECT_NEAR(scene.cam->face_half_width.value(), std::sqrt(15e-3 * 15e-3 - 7e-3 * 7e-3), 1e-15);
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    EXPECT_LE(solution.cam->summary.contact_offset->value, *scene.cam->face_half_width * (1.0 + 1e-7));
    EXPECT_TRUE(std::ranges::any_of(solution.constraints, [](const ConstraintReport& report) {
        return report.key == "cam.face_radius_mm" && report.active;
    }));
}

}  // namespace prescribed_motion_test
}  // namespace camopt
