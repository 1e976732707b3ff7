// SPDX-License-Identifier: MIT
// The output of an elastic train prescribed: against references of independent linear programs, an integrator
// that knows nothing of camopt, and dense samples of what the cam is held to.
#include "core/units.hpp"
#include "objectives/scene_family.hpp"
#include "studies/response/train_study.hpp"
#include "studies/restored/restored_solution.hpp"
#include "studies/solve/solve.hpp"
#include "tests/dynamics/stiff_integrator.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <random>

namespace camopt {
namespace prescribed_output_test {

using namespace testing_support;

/// A rise of a tenth of a second, so that λ is a tenth of the natural frequency in Hz.
TestScene rise(double ratio, int segments) {
    const TestScene scene(R"(
[motion]
type = "DRD"
lift_mm = 20
rise_deg = 60
speed_rpm = 100
within_lift = false
[spline]
degree = 5
segments = 24
[objective]
velocity = 0.4
acceleration = 0.4
jerk = 0.2
reference = { velocity = 1.76, acceleration = 5.53, jerk = 69 }
[dynamics]
mass_kg = 2
natural_frequency_hz = 20
prescribe = "output"
[solver]
tolerance = 1e-10
)");
    return scene.set("spline.segments", segments).set("dynamics.natural_frequency_hz", 10.0 * ratio);
}

void expect_optimum(const Scene& scene, double objective, const std::array<double, 3>& peaks) {
    const Solution solution = solve(scene);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(solution.certificate.objective, objective, 1e-7 * objective);
    // Of equally good motions the tie-break takes one.
    EXPECT_NEAR(solution.peaks.velocity.value, peaks[0], 5e-5);
    EXPECT_NEAR(solution.peaks.acceleration.value, peaks[1], 1e-4);
    EXPECT_NEAR(solution.peaks.jerk.value, peaks[2], 2e-3);
}

TEST(PrescribedOutput, MatchesIndependentProgram) {
    expect_optimum(rise(2.0, 24), 1.0882080541, {1.9185862, 5.9725949, 75.9523198});
    expect_optimum(rise(1.2, 24), 1.0882080541, {1.9185862, 5.9725949, 75.9523198});
    const auto limited = [](double ratio, double most) {
        return rise(ratio, 20).set("limits.cam_acceleration", most);
    };
    expect_optimum(limited(2.0, 9.0), 1.1298897215, {2.0060452, 6.6446833, 66.7030864});
    expect_optimum(limited(2.0, 7.0), 1.1724392734, {2.1605909, 6.8903410, 63.1345536});
    expect_optimum(limited(3.0, 6.2), 1.1114964765, {1.9578315, 6.1689146, 76.0105165});
    expect_optimum(limited(1.2, 15.0), 1.2065469576, {2.1827077, 7.3240393, 62.3446933});
}

/// Amplitude in lifts after the rise, by the integrator; time in seconds, the cam in lifts.
double residual_of(const Scene& scene, const Motion& cam) {
    const DynamicsSpec& train = *scene.dynamics;
    const TrainStage output = train.output();
    const double pace = *scene.motion.speed / scene.motion.unit_angle(), end = cam.end() / pace;
    stiff::Chain chain;
    chain.masses = {{output.mass, output.stiffness, output.damping}};
    chain.return_stiffness = train.return_stiffness;
    chain.input = [&](double time) {
        const MotionPoint at = cam.at(std::min(time * pace, cam.end()));
        return stiff::Input{at.derivative[0], at.derivative[1] * pace, at.derivative[2] * pace * pace};
    };
    const std::vector<double> state = stiff::integrated(chain, end, 1e-12);
    const double total = output.stiffness + train.return_stiffness,
                 frequency = std::sqrt(total / output.mass);
    const double rest = output.stiffness / total * cam.at(cam.end(), Side::left).derivative[0];
    return std::hypot(state[0] - rest, state[1] / frequency);
}

TEST(PrescribedOutput, LeavesNoVibrationAtItsSpeed) {
    for (const TestScene& scene :
         {rise(2.0, 16), rise(3.5, 20).with("limits.cam_acceleration = 8"),
          rise(2.0, 16).with("dynamics.return_spring_n_mm = 4", "dynamics.preload_n = 100")}) {
        const Solution solution = solve(scene);
        ASSERT_TRUE(solution.output);
        EXPECT_LT(residual_of(solution.scene, *solution.motion), 1e-9);
        ASSERT_TRUE(solution.train && solution.train->residual);
        EXPECT_LT(solution.train->residual->value, 1e-9);
        // The output arrives where it shall, and the cam goes as far as the return spring needs.
        const double share = cam_of_output(solution.scene).weights[0];
        EXPECT_NEAR(solution.output->at(1.0, Side::left).derivative[0], 1.0, 1e-12);
        EXPECT_NEAR(solution.motion->at(1.0, Side::left).derivative[0], share, 1e-10);
    }
}

TEST(PrescribedOutput, FollowsDamperToGround) {
    const Scene scene = rise(2.0, 16).with("dynamics.ground_damping_n_s_m = 40");
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.train && solution.train->residual);
    EXPECT_GT(cam_of_output(solution.scene).weights[1], 0.0);
    EXPECT_LT(solution.train->residual->value, 1e-9);
}

TEST(PrescribedOutput, CamIsCombinationOfOutput) {
    const Solution solution =
        solve(rise(2.0, 20).with("limits.cam_acceleration = 9", "dynamics.return_spring_n_mm = 2"));
    ASSERT_TRUE(solution.output);
    const auto [by_y, by_slope, by_bend] = cam_of_output(solution.scene).weights;
    EXPECT_EQ(by_slope, 0.0);
    for (int k = 0; k <= 500; ++k) {
        const double x = k / 500.0;
        const auto y = solution.output->at(x).derivative;
        const auto s = solution.motion->at(x).derivative;
        EXPECT_NEAR(s[0], by_y * y[0] + by_bend * y[2], 1e-11);
        EXPECT_NEAR(s[1], by_y * y[1] + by_bend * y[3], 1e-9);
        EXPECT_LE(std::abs(s[2]), 9.0 * (1.0 + 1e-8));
    }
    EXPECT_NEAR(solution.cam_peaks.acceleration.value, 9.0, 1e-7);
}

/// With damping, and at speeds that are not the train's, it still rings less than what ignores the train.
TEST(PrescribedOutput, RingsLessThanRigidOptimumNearby) {
    std::mt19937 engine(57);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(engine()) / 4294967295.0;
    };
    for (int trial = 0; trial < 20; ++trial) {
        const double ratio = uniform(1.5, 6.0);
        const TestScene scene = rise(ratio, 16).with("dynamics.damping_ratio = 0.02");
        const Scene read = scene;
        const double speed = *read.motion.speed;
        const TrainStudy study = train_study(read, {0.9 * speed, 1.1 * speed, 3});
        const auto worst = [&](const std::string& motion) {
            double largest = 0.0;
            for (const TrainRow& row : study.rows)
                if (row.motion == motion) largest = std::max(largest, row.residual);
            return largest;
        };
        EXPECT_LT(worst("optimum"), worst("static_optimum")) << ratio;
        EXPECT_LT(worst("optimum"), worst("modified_sine")) << ratio;
    }
}

TEST(PrescribedOutput, PolydyneLeavesNoVibration) {
    const Scene scene = rise(2.0, 16);
    const TrainStudy study = train_study(scene, {0.8 * *scene.motion.speed, *scene.motion.speed, 2});
    const auto row = std::ranges::find_if(study.rows, [&](const TrainRow& one) {
        return one.motion == "polydyne" && one.speed == *scene.motion.speed;
    });
    ASSERT_NE(row, study.rows.end());
    EXPECT_LT(row->residual, 1e-10);
    ASSERT_FALSE(study.detuned.empty());
    EXPECT_LT(study.detuned.front().residual[1], 1e-9);
    EXPECT_GT(study.detuned.front().residual[0], 1e-6);
}

TEST(PrescribedOutput, NeedsTheFormulasOfItsTrain) {
    Scene scene = rise(2.0, 16);
    scene.dynamics->formulas.reset();
    EXPECT_TRUE(says(refusal([&] { (void)solve(scene); }), "without its formulas"));
}

TEST(PrescribedOutput, HoldsCamToItsLimits) {
    const Solution solution =
        solve(rise(2.5, 20).with("cam = { type = 'disk', follower = 'translating_roller', base_radius_mm = "
                                 "30, roller_radius_mm = 10 }",
                                 "limits.pressure_angle_deg = 31", "limits.cam_radius_min_mm = 1"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_TRUE(solution.cam);
    const double prime = 40.0, lift = 20.0, angle = solution.scene.motion.unit_angle();
    double steepest = 0.0;
    for (int k = 0; k <= 4000; ++k) {
        const auto s = solution.motion->at(k / 4000.0).derivative;
        steepest = std::max(steepest, std::atan(std::abs(lift * s[1] / angle) / (prime + lift * s[0])));
    }
    EXPECT_LE(steepest, 31.0 * units::degree * (1.0 + 1e-7));
    EXPECT_GE(steepest, 30.9 * units::degree);
}

TEST(PrescribedOutput, GoesThroughProgramWithDwells) {
    const Solution solution = solve(rise(2.0, 16).with(
        "motion = { type = 'program', lift_mm = 20, speed_rpm = 100, segments = ["
        "{ kind = 'spline', angle_deg = 90, to_mm = 20 }, { kind = 'dwell', angle_deg = 60 }, "
        "{ kind = 'spline', angle_deg = 90, to_mm = 0 }, { kind = 'dwell', angle_deg = 120 }] }",
        "dynamics.return_spring_n_mm = 3"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_TRUE(solution.train && solution.train->residual);
    EXPECT_LT(solution.train->residual->value, 1e-9);
}

/// A load of 2 kg on a belt, a motor of 4e-5 kg m² with 20 mm a turn.
TestScene axis() {
    return rise(2.5, 16).with(
        "objective = { jerk = 0.1, motor_torque_rms = 1, reference = { jerk = 69, motor_torque_rms = 1 } }",
        "drive = { motor_inertia_kg_m2 = 4e-5, load_mass_kg = 0.3, transmission_mm_per_rev = 20 }",
        "limits.motor_speed_rpm = 1300");
}

TEST(PrescribedOutput, MotorMovesLoadThroughItsSpring) {
    const Solution solution = solve(axis());
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_TRUE(solution.drive && solution.output);
    EXPECT_LT(residual_of(solution.scene, *solution.motion), 1e-9);
    const double travel = 0.02 / units::turn, lift = 0.02, pace = 10.0;  // lifts a second
    double largest = 0.0, fastest = 0.0, square = 0.0;
    constexpr int places = 20000;
    for (int k = 0; k <= places; ++k) {
        const auto y = solution.output->at(static_cast<double>(k) / places).derivative;
        const auto s = solution.motion->at(static_cast<double>(k) / places).derivative;
        const double motor = lift * pace * pace * s[2], load = lift * pace * pace * y[2];
        const double torque = travel * (0.3 * motor + 2.0 * load) + 4e-5 / travel * motor;
        largest = std::max(largest, std::abs(torque));
        fastest = std::max(fastest, std::abs(lift * pace * s[1]) / travel);
        square += torque * torque / places;
    }
    EXPECT_NEAR(solution.drive->torque.value, largest, 1e-5 * largest);
    EXPECT_NEAR(solution.drive->speed.value, fastest, 1e-6 * fastest);
    const double cycle = units::turn / solution.scene.motion.unit_angle();
    EXPECT_NEAR(solution.drive->rms_torque, std::sqrt(square / cycle), 1e-4 * solution.drive->rms_torque);
    EXPECT_LE(fastest, 1300 * units::revolution_per_minute * (1.0 + 1e-7));
}

TEST(PrescribedOutput, MotorKeepsTorqueOfBoth) {
    const Solution free = solve(axis());
    const double most = 0.9 * free.drive.value().torque.value;
    const Solution held = solve(axis().set("limits.motor_torque_nm", most));
    ASSERT_TRUE(held.drive);
    EXPECT_EQ(held.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(held.drive->torque.value, most, 1e-7 * most);
    EXPECT_GT(held.certificate.objective, free.certificate.objective);
    EXPECT_NE(refusal([&] {
                  (void)solve(axis().with("drive.friction_n = 3", "motion.monotone = true"));
              }).find("drive.friction"),
              std::string::npos);
}

TEST(PrescribedOutput, RefusesWhatItCannotMean) {
    const TestScene scene = rise(2.0, 16);
    EXPECT_NE(refusal([&] { (void)solve(scene.with("spline.degree = 3")); }).find("5 or 7"),
              std::string::npos);
    EXPECT_NE(refusal([&] { (void)solve(scene.with("spline.continuity = 3")); }).find("4 or more"),
              std::string::npos);
    EXPECT_NE(refusal([&] {
                  (void)solve(scene.with("dynamics.prescribe = 'cam'", "limits.cam_velocity = 2"));
              }).find("limits.cam_velocity"),
              std::string::npos);
    EXPECT_NE(refusal([&] {
                  (void)solve(scene.with(
                      "dynamics.stage = [{ mass_kg = 1, stiffness_n_mm = 900, damping_ratio = 0 }]"));
              }).find("one mass"),
              std::string::npos);
}

}  // namespace prescribed_output_test
}  // namespace camopt
