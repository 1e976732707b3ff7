// SPDX-License-Identifier: MIT
// Machines of servo axes: the largest speed that their motors allow, and time shared out between strokes.
#include "core/units.hpp"
#include "objectives/drive_rules.hpp"
#include "studies/machine/machine.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace camopt {
namespace machine_drive_test {

/// A slide that goes and comes back; `out`, `back`: cam angles of the strokes as TOML.
Scene slide(double lift_mm, const char* out, const char* back, double rest_deg) {
    return testing_support::scene_named("servo_there_and_back")
        .with(std::string("motion.segments[0].angle_deg = ") + out,
              std::string("motion.segments[2].angle_deg = ") + back)
        .set("motion.segments[1].angle_deg", rest_deg)
        .set("motion.lift_mm", lift_mm);
}

MachineSpec machine_of(std::vector<Scene> scenes) {
    MachineSpec machine;
    machine.least_speed = 10.0 * units::revolution_per_minute;
    machine.most_speed = 2000.0 * units::revolution_per_minute;
    for (Scene& scene : scenes) {
        machine.axes.emplace_back();
        machine.axes.back().name = fmt::format("axis{}", machine.axes.size());
        machine.axes.back().scene = std::move(scene);
    }
    return machine;
}

TEST(MachineDrive, SpeedIsThatOfSlowestMotor) {
    const MachineSpec machine =
        machine_of({slide(60.0, "120", "140", 60.0), slide(80.0, "150", "130", 40.0)});
    const MachineSolution solution = solve_machine(machine);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_TRUE(solution.impossible_above);
    EXPECT_FALSE(solution.scanned);
    EXPECT_LE(*solution.impossible_above, 1.001 * solution.speed * (1.0 + 1e-9));
    ASSERT_FALSE(solution.limited_by.empty());
    EXPECT_EQ(solution.limited_by.front().axis, 1);
    for (const Solution& axis : solution.axes) {
        const DriveAlong along(axis.scene);
        for (int k = 0; k <= 10000; ++k) {
            const double x = axis.motion->begin() + (axis.motion->end() - axis.motion->begin()) * k / 10000;
            const Side side = k < 10000 ? Side::right : Side::left;
            ASSERT_LE(std::abs(along.at(axis.motion->at(x, side), side).torque), 4.0 * (1.0 + 1e-6));
        }
        EXPECT_LE(axis.drive->rms_torque, 2.0 * (1.0 + 1e-6));
    }
    // Alone the slower axis has motions at the speed, and none a little above.
    const Scene& slower = machine.axes[1].scene;
    EXPECT_EQ(solve(at_speed(slower, solution.speed)).certificate.verdict, Verdict::optimal);
    EXPECT_EQ(solve(at_speed(slower, *solution.impossible_above)).certificate.verdict, Verdict::infeasible);
}

TEST(MachineDrive, TimeIsSharedOutBetweenStrokes) {
    const MachineSpec given = machine_of({slide(60.0, "190", "90", 40.0)});
    MachineSpec ranges =
        machine_of({slide(60.0, "{ min = 90, max = 190 }", "{ min = 90, max = 190 }", 40.0)});
    ranges.axes[0].scene.motion.segments[0].angle = 190.0 * units::degree;
    ranges.axes[0].scene.motion.segments[2].angle = 90.0 * units::degree;
    const MachineSolution fixed = solve_machine(given), found = solve_machine(ranges);
    ASSERT_TRUE(found.timing && found.timing->given);
    EXPECT_NEAR(*found.timing->given / fixed.speed, 1.0, 5e-3);
    EXPECT_GT(found.speed, 1.2 * fixed.speed) << "equal strokes need equal times";
    EXPECT_EQ(found.certificate.verdict, Verdict::local);
    double sum = 0.0;
    for (const ProgramSegment& segment : found.spec.axes[0].scene.motion.segments) sum += segment.angle;
    EXPECT_NEAR(sum, units::turn, 1e-9);
    EXPECT_NEAR(found.spec.axes[0].scene.motion.segments[0].angle / units::degree, 140.0, 6.0);
}

TEST(MachineDrive, HoldingTorqueContradictsAnySpeed) {
    Scene scene = slide(60.0, "140", "140", 40.0);
    scene.drive->force = 1000.0;  // 7.96 N m
    const MachineSolution solution = solve_machine(machine_of({scene}));
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_TRUE(solution.at_standstill);
}

}  // namespace machine_drive_test
}  // namespace camopt
