// SPDX-License-Identifier: MIT
// Machines: the largest speed with its proof, what stops it, and what contradicts itself.
#include "studies/machine/machine.hpp"

#include "input/loading/load_scene.hpp"
#include "input/machine/machine_reader.hpp"
#include "studies/least/monotone.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace camopt {
namespace machine_test {

using testing_support::refusal;

MachineSpec cartoner(const std::vector<std::string>& settings = {}) {
    return input::read_machine(std::filesystem::path(source_folder()) / "scenes/machines/cartoner.toml",
                               load_scene, settings);
}

double rpm(double speed) {
    return speed / units::revolution_per_minute;
}

const MachineSolution& solved_cartoner() {
    static const MachineSolution solution = solve_machine(cartoner());
    return solution;
}

TEST(Machine, LargestSpeedLiesBetweenMotionsAndProof) {
    const MachineSolution& solution = solved_cartoner();
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_TRUE(solution.impossible_above && solution.impossible);
    EXPECT_GT(*solution.impossible_above, solution.speed);
    EXPECT_LE(*solution.impossible_above, solution.speed * (1.0 + 1e-3) * (1.0 + 1e-9));
    EXPECT_GT(recomputed_bound(*solution.impossible), 0.0);
    EXPECT_LE(solution.trials, 16);
    ASSERT_EQ(solution.axes.size(), 3U);
    double sum = 0.0;
    for (const Solution& axis : solution.axes) {
        EXPECT_EQ(axis.certificate.verdict, Verdict::feasible);
        EXPECT_LE(axis.certificate.worst_violation, 1e-9);
        EXPECT_NEAR(*axis.scene.motion.speed, solution.speed, 1e-12);
        sum += axis.certificate.objective;
    }
    EXPECT_NEAR(sum, solution.certificate.objective, 1e-9);
}

TEST(Machine, DeliveredMotionsKeepEveryClearance) {
    const MachineSolution& solution = solved_cartoner();
    std::vector<MotionChain> turns;
    for (const Solution& axis : solution.axes) turns.push_back(axis.whole_turn());
    constexpr int samples = 10000;
    for (std::size_t k = 0; k < solution.spec.clearances.size(); ++k) {
        const Clearance& clearance = solution.spec.clearances[k];
        double least = infinity;
        for (int i = 0; i <= samples; ++i) {
            const double angle = clearance.from + (clearance.to - clearance.from) * i / samples;
            double sum = -clearance.at_least;
            for (std::size_t j = 0; j < clearance.axes.size(); ++j) {
                const auto b = static_cast<std::size_t>(clearance.axes[j]);
                const MotionSpec& motion = solution.axes[b].scene.motion;
                const double own = std::fmod(angle - solution.spec.axes[b].phase + units::turn, units::turn);
                const double x = std::min(own / motion.unit_angle(), turns[b].end());
                sum += clearance.factors[j] * motion.lift * turns[b].at(x).derivative[0];
            }
            least = std::min(least, sum);
        }
        EXPECT_GE(least, -1e-9);
        EXPECT_NEAR(least, solution.clearances[k].value, 1e-6);
    }
}

TEST(Machine, NeededLimitAloneAllowsFivePercentMore) {
    const MachineSolution& solution = solved_cartoner();
    double shares = 0.0;
    for (const MachineLimit& limit : solution.limited_by) shares += limit.share;
    EXPECT_NEAR(shares, 1.0, 1e-2);
    ASSERT_FALSE(solution.limited_by.empty());
    EXPECT_EQ(solution.limited_by.front().key, "clearance[1].at_least_mm");
    const auto plunger = std::ranges::find_if(solution.limited_by, [](const MachineLimit& limit) {
        return limit.axis == 2 && limit.key == "limits.acceleration_m_s2";
    });
    ASSERT_NE(plunger, solution.limited_by.end());
    ASSERT_TRUE(plunger->needed);
    const auto speed_with = [&](double acceleration) {
        MachineSpec machine = solution.spec;
        PeakLimit& limit = *machine.axes[2].scene.limits.acceleration;
        limit.normalised *= acceleration / limit.given;
        limit.given = acceleration;
        return solve_machine(machine).speed;
    };
    EXPECT_NEAR(speed_with(*plunger->needed) / solution.speed, 1.05, 1.2e-3);
}

TEST(Machine, GivenSpeedHasLeastTotalObjective) {
    const MachineSolution apart = solve_machine(cartoner({"machine.speed_rpm=100", "clearance=[]"}));
    const MachineSolution joined = solve_machine(cartoner({"machine.speed_rpm=100"}));
    for (const MachineSolution* solution : {&apart, &joined}) {
        EXPECT_EQ(solution->certificate.verdict, Verdict::optimal);
        EXPECT_LE(solution->certificate.gap.value_or(1.0), 1e-7);
        EXPECT_FALSE(solution->impossible_above);
    }
    EXPECT_LT(apart.certificate.objective, joined.certificate.objective - 1e-3);
    EXPECT_LT(apart.clearances.size(), joined.clearances.size());
}

TEST(Machine, ContradictionAtAnySpeedIsNamed) {
    const MachineSolution solution = solve_machine(cartoner({"clearance[1].at_least_mm=-90"}));
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_TRUE(solution.at_standstill);
    ASSERT_TRUE(solution.certificate.proof);
    EXPECT_GT(recomputed_bound(*solution.certificate.proof), 0.0);
    ASSERT_FALSE(solution.limited_by.empty());
    EXPECT_EQ(solution.limited_by.front().clearance, 1);
    EXPECT_TRUE(solution.axes.empty());
}

TEST(Machine, TooFastRangeIsInfeasible) {
    const MachineSolution solution = solve_machine(cartoner({"machine.speed_rpm={min=300,max=400}"}));
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_FALSE(solution.at_standstill);
    EXPECT_NEAR(rpm(solution.speed), 300.0, 1e-9);
    EXPECT_FALSE(solution.limited_by.empty());
}

TEST(Machine, EndOfTheRangeIsReached) {
    const MachineSolution solution = solve_machine(cartoner({"machine.speed_rpm={min=50,max=80}"}));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_TRUE(solution.reached_most);
    EXPECT_NEAR(rpm(solution.speed), 80.0, 1e-9);
    EXPECT_TRUE(solution.limited_by.empty());
}

TEST(Machine, LimitsThatAreNotConvexAreRefused) {
    MachineSpec machine = cartoner();
    machine.axes[1].scene.objective.torque = 0.5;
    const std::string said = refusal([&] { (void)solve_machine(machine); });
    EXPECT_NE(said.find("axis[1].scene.objective.torque: found a limit or term that is not convex"),
              std::string::npos)
        << said;
}

MachineSpec shed(const std::vector<std::string>& settings = {}) {
    return input::read_machine(std::filesystem::path(source_folder()) / "scenes/machines/shed.toml",
                               load_scene, settings);
}

TEST(Machine, ShedOfTwoFramesStaysOpen) {
    const MachineSolution solution = solve_machine(shed());
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    const MachineSolution closer =
        solve_machine(shed({"clearance[0].at_least_mm=60", "clearance[1].at_least_mm=60"}));
    EXPECT_GT(solution.certificate.objective, closer.certificate.objective + 5e-3);
    ASSERT_EQ(solution.axes.size(), 2U);
    const std::array turns = {solution.axes[0].whole_turn(), solution.axes[1].whole_turn()};
    const auto at = [&](std::size_t frame, double degrees) {
        const double own = degrees - (frame == 1 ? 180.0 : 0.0);
        const double unit = solution.axes[frame].scene.motion.unit_angle() / units::degree;
        return 80.0 * turns[frame].at(std::fmod(own + 360.0, 360.0) / unit).derivative[0];
    };
    double least = 100.0, without = 100.0;
    for (double degrees = 162.5; degrees <= 272.5; degrees += 0.01)
        least = std::min(
            {least, at(0, degrees) - at(1, degrees), at(1, degrees + 180.0) - at(0, degrees + 180.0)});
    EXPECT_NEAR(least, 75.5, 1e-5);
    for (const Extremum& shed : closer.clearances) without = std::min(without, shed.value);
    EXPECT_NEAR(60e-3 + without, 74.40e-3, 1e-5);  // what is left of it where nothing is required
    for (const Solution& frame : solution.axes)
        EXPECT_LT(frame.cam->summary.pressure_angle.value, 33.0 * units::degree);
}

TEST(Machine, ViolatedNonconvexLimitIsRefused) {
    EXPECT_EQ(refusal([] { (void)solve_machine(shed({"front.limits.pressure_angle_deg=30"})); }),
              "axis[0].scene.limits.pressure_angle_deg: found a limit that is not convex, and that the best "
              "motions "
              "without it do not satisfy; allowed: in a machine at a given speed limits that are convex, or "
              "satisfied by these motions");
}

TEST(Machine, SearchedNumbersOfAxesAreRefused) {
    MachineSpec free = cartoner();
    free.axes[1].scene.spline.free_knots = true;
    EXPECT_EQ(refusal([&] { (void)solve_machine(free); }),
              "axis[1].scene.spline.knots: found \"free\"; allowed: in a machine fixed breakpoints");
    MachineSpec seeking = cartoner();
    seeking.axes[0].scene.objective.sought = SoughtKey{"limits.jerk", false};
    EXPECT_EQ(
        refusal([&] { (void)solve_machine(seeking); }),
        "axis[0].scene.objective.least: found \"limits.jerk\"; allowed: none in an axis: a machine seeks its "
        "largest speed, where machine.speed is a range");
    MachineSpec sprung = cartoner();
    sprung.axes[2].scene.forces.emplace().preload_range = {1.0, 2.0};
    EXPECT_EQ(refusal([&] { (void)solve_machine(sprung); }),
              "axis[2].scene.forces.preload: found a range; allowed: in a machine a fixed number");
}

TEST(Machine, OtherLimitsAreScanned) {
    MachineSpec machine = cartoner({"machine.speed_rpm={min=60,max=100}"});
    SetPoint point;
    point.at = 0.5;
    point.velocity = 1.6;
    point.units.velocity = "mm/s";
    machine.axes[1].scene.motion.segments[0].via = {point};
    EXPECT_FALSE(only_tightens_with_speed(machine.axes[1].scene));
    EXPECT_TRUE(only_tightens_with_speed(machine.axes[0].scene));
    MachineOptions options;
    options.scanned_speeds = 3;
    const MachineSolution solution = solve_machine(machine, options);
    EXPECT_TRUE(solution.scanned);
    EXPECT_NE(std::ranges::find_if(solution.notes,
                                   [](const std::string& note) {
                                       return note.find("do not only tighten") != std::string::npos ||
                                              note.find("speeds over the range") != std::string::npos;
                                   }),
              solution.notes.end());
}

}  // namespace machine_test
}  // namespace camopt
