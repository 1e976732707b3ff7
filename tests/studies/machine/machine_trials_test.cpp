// SPDX-License-Identifier: MIT
// Machines whose largest speed is known from elsewhere, and random ones compared with redundant twins.
#include "input/loading/load_scene.hpp"
#include "input/machine/machine_reader.hpp"
#include "studies/machine/machine.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/source_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

namespace camopt {
namespace machine_trials_test {

MachineSpec machine_case(const std::string& name, const std::vector<std::string>& settings = {}) {
    return input::read_machine(std::filesystem::path(source_folder()) / "tests/cases" / name, load_scene,
                               settings);
}

double rpm(double speed) {
    return speed / units::revolution_per_minute;
}

/// The largest speed of which motions are known is within the gap of `right`, and proved to be.
void expect_largest(const MachineSolution& solution, double right) {
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    ASSERT_FALSE(solution.axes.empty());
    EXPECT_NEAR(rpm(solution.speed), right, 1e-3 * right);
    ASSERT_TRUE(solution.impossible_above && solution.impossible);
    EXPECT_LE(*solution.impossible_above, solution.speed * (1.0 + 1e-3) * (1.0 + 1e-9));
    EXPECT_GE(rpm(*solution.impossible_above), right * (1.0 - 1e-5));
    EXPECT_GT(recomputed_bound(*solution.impossible), 0.0);
}

TEST(MachineTrials, SidedAccelerationLimitIsProved) {
    const MachineSolution solution = solve_machine(machine_case("machine_half_speed/machine.toml"));
    expect_largest(solution, 216.2);
    EXPECT_GE(rpm(solution.speed), 215.70);
}

TEST(MachineTrials, IdleAxisChangesNothing) {
    MachineSpec machine = machine_case("machine_idle/machine.toml");
    expect_largest(solve_machine(machine), 222.82);
    machine.axes.pop_back();
    expect_largest(solve_machine(machine), 222.82);
}

TEST(MachineTrials, StrokeLeavingItsLiftIsProved) {
    expect_largest(solve_machine(machine_case("56_shear.toml")), 92.7711);
}

TEST(MachineTrials, ClearanceThatTouchesIsNoContradiction) {
    expect_largest(solve_machine(machine_case("machine_touching/machine.toml")), 148.24);
}

/// A machine at a given speed whose optimum is known, to `error`.
void expect_optimum(const std::string& name, double optimum, double error) {
    const MachineSolution solution = solve_machine(machine_case(name));
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(solution.certificate.objective, optimum, error + 1e-8 * optimum);
    ASSERT_TRUE(solution.certificate.lower_bound);
    EXPECT_LE(*solution.certificate.lower_bound, optimum + error);
}

TEST(MachineTrials, WeightsOfZeroAreProved) {
    expect_optimum("machine_weights_of_zero/machine.toml", 0.74471865477959831, 7.7e-9);
}

TEST(MachineTrials, CloseConditionsAreNoContradiction) {
    expect_optimum("machine_close_conditions/machine.toml", 2.1045210078617638, 2.4e-5);
}

TEST(MachineTrials, ImpossibleByHundredMillionthIsProved) {
    const MachineSolution solution = solve_machine(machine_case("machine_impossible/machine.toml"));
    EXPECT_EQ(solution.certificate.verdict, Verdict::infeasible);
    ASSERT_TRUE(solution.certificate.proof);
    EXPECT_GT(recomputed_bound(*solution.certificate.proof), 0.0);
    EXPECT_FALSE(solution.limited_by.empty());
}

TEST(MachineTrials, FactorOfZeroLeavesAxisOut) {
    const char* const name = "machine_indexing/55_press.toml";
    const MachineSolution with = solve_machine(machine_case(name));
    const MachineSolution without =
        solve_machine(machine_case(name, {"clearance[0].between=[\"die\"]", "clearance[0].factors=[-1.0]"}));
    expect_largest(with, rpm(without.speed));
    EXPECT_EQ(without.certificate.verdict, Verdict::optimal);
}

/// The least of a clearance less what it must be, over the tables of the axes.
double least_of(const MachineSolution& solution, std::size_t index) {
    const Clearance& clearance = solution.spec.clearances[index];
    constexpr int samples = 7200;
    double least = infinity;
    for (int i = 0; i <= samples; ++i) {
        const double angle = clearance.from + (clearance.to - clearance.from) * i / samples;
        double sum = -clearance.at_least;
        for (std::size_t k = 0; k < clearance.axes.size(); ++k) {
            const auto b = static_cast<std::size_t>(clearance.axes[k]);
            const Solution& axis = solution.axes[b];
            const double own = angle - solution.spec.axes[b].phase;
            const double cycles = std::floor(own / units::turn);
            const MotionSpec& motion = axis.scene.motion;
            const MotionChain turn = axis.whole_turn();
            const double advance = motion.relative ? turn.at(turn.end(), Side::left).derivative[0] : 0.0;
            const double x = std::min((own - units::turn * cycles) / motion.unit_angle(), turn.end());
            sum += clearance.factors[k] * motion.lift * (turn.at(x).derivative[0] + cycles * advance);
        }
        least = std::min(least, sum);
    }
    return least;
}

TEST(MachineTrials, AdvanceCountsFromStartOfCycle) {
    for (const double phase : {0.0, 40.0}) {
        MachineSpec machine =
            machine_case("machine_indexing/55_press.toml",
                         {fmt::format("axis[0].phase_deg={}", phase), "axis[1].phase_deg=0",
                          "clearance[0]={between=[\"die\",\"mill\"],factors=[-1.0,-0.5],at_least_mm=-58}"});
        const MachineSolution solution = solve_machine(machine);
        EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
        ASSERT_EQ(solution.clearances.size(), 1U);
        EXPECT_NEAR(least_of(solution, 0), solution.clearances[0].value, 1e-6) << phase;
        EXPECT_GE(solution.clearances[0].value, -1e-9) << phase;
        if (phase == 0.0) {  // the stroke of the mill and the end of that of the die overlap
            EXPECT_LE(solution.clearances[0].value, 1e-6);
        }
    }
}

TEST(MachineTrials, LastDisplacementMayBeLeftOut) {
    const MachineSpec given = machine_case("machine_idle/machine.toml");
    MachineSpec open = given;
    open.axes[0].scene.motion.segments[1].to.reset();
    EXPECT_NEAR(solve_machine(open).speed / solve_machine(given).speed, 1.0, 1e-3);
}

TEST(MachineTrials, AxisSaysWhatShapesIt) {
    const MachineSolution solution = solve_machine(
        input::read_machine(std::filesystem::path(source_folder()) / "scenes/machines/cartoner.toml",
                            load_scene, std::vector<std::string>{}));
    ASSERT_EQ(solution.axes.size(), 3U);
    int shaped = 0;
    for (const Solution& axis : solution.axes) {
        EXPECT_NE(axis.machine.find("deg of the master"), std::string::npos);
        shaped += axis.machine.find("clearance[1].at_least_mm shapes it") != std::string::npos ? 1 : 0;
    }
    EXPECT_EQ(shaped, 2);
}

/// A random machine of one to three axes, and twins of it that allow the same speeds.
class RandomMachine {
 public:
    struct Twin {
        const char* name = "";
        bool doubled = false;  ///< every lift, and half of every displacement in lifts
        bool rests = false;    ///< a turning point is said to rest, which it does
        bool idle = false;     ///< an axis more, which needs nothing
    };

    explicit RandomMachine(unsigned seed) : engine_(seed) {
        const int axes = 1 + whole(3);
        for (int b = 0; b < axes; ++b) draw_axis(b);
        for (int k = axes > 1 ? whole(3) : 0; k > 0; --k) {
            Clearance clearance;
            clearance.axes = {0, 1};
            clearance.factors = {0.5 + part(), -0.5 - part()};
            clearance.at_least = 1e-3 * (-clearance.factors[0] * axes_[0].lift * part() +
                                         clearance.factors[1] * axes_[1].lift * (0.3 + 0.7 * part()));
            clearances_.push_back(clearance);
        }
    }

    [[nodiscard]] MachineSpec made(const Twin& twin) const {
        MachineSpec machine;
        machine.least_speed = 5.0 * units::revolution_per_minute;
        machine.most_speed = 2000.0 * units::revolution_per_minute;
        for (const Axis& axis : axes_) machine.axes.push_back(spec_of(axis, twin));
        if (twin.idle) machine.axes.push_back(spec_of(idle, twin));
        machine.clearances = clearances_;
        return machine;
    }

 private:
    struct Axis {
        std::string name;
        double phase = 0.0, lift = 1.0, top = 1.0, rise = 180.0, dwell = 0.0;  ///< deg, mm
        std::string rest = {};                                                 ///< [spline] to [limits]
    };

    double part() { return static_cast<double>(engine_()) / 4294967295.0; }
    int whole(int below) { return std::min(below - 1, static_cast<int>(part() * below)); }

    void draw_axis(int index) {
        Axis axis{fmt::format("a{}", index)};
        axis.phase = index == 0 ? 0.0 : std::floor(360.0 * part());
        axis.lift = std::round(20.0 + 100.0 * part());
        axis.top = std::round(40.0 + 60.0 * part()) / 100.0;
        axis.rise = std::round(80.0 + 60.0 * part());
        axis.dwell = whole(2) * std::round(90.0 * part());
        const int degree = 3 + 2 * whole(2);
        axis.rest =
            fmt::format("[spline]\ndegree = {}\nsegments = {}\n[objective]\nacceleration = 1\n[limits]\n",
                        degree, 5 + whole(6));
        const double most = std::round(10.0 + 100.0 * part());
        axis.rest += whole(2) == 0 ? fmt::format("acceleration_m_s2 = {}\n", most)
                                   : fmt::format("acceleration_m_s2 = {{ min = {}, max = {} }}\n",
                                                 -std::round(most * (0.6 + part())), most);
        if (whole(3) == 0)
            axis.rest += fmt::format("velocity_m_s = {}\n", std::round(10.0 + 20.0 * part()) / 10.0);
        if (whole(3) == 0)
            axis.rest += fmt::format("jerk_m_s3 = {}\n", most * std::round(40.0 + 100.0 * part()));
        axes_.push_back(axis);
    }

    static AxisSpec spec_of(const Axis& axis, const Twin& twin) {
        const double factor = twin.doubled ? 2.0 : 1.0;
        std::string toml = fmt::format(
            "[motion]\ntype = \"program\"\nlift_mm = {}\nspeed_rpm = 60\nsegments = [ {{ kind = \"spline\", "
            "angle_deg = {}, to = {}{} }},",
            factor * axis.lift, axis.rise, axis.top / factor,
            twin.rests && axis.dwell == 0.0 ? ", end = { velocity = 0 }" : "");
        if (axis.dwell > 0.0) toml += fmt::format("{{ kind = \"dwell\", angle_deg = {} }},", axis.dwell);
        toml += fmt::format("{{ kind = \"spline\", angle_deg = {}, to = 0 }} ]\n",
                            360.0 - axis.rise - axis.dwell);
        AxisSpec spec;
        spec.name = axis.name;
        spec.phase = axis.phase * units::degree;
        spec.scene = scene_of_toml(toml + axis.rest);
        return spec;
    }

    inline static const Axis idle{"idle",
                                  17.0,
                                  1.0,
                                  1.0,
                                  180.0,
                                  0.0,
                                  "[spline]\nsegments = 6\n[objective]\nacceleration = 1\n"
                                  "[limits]\nacceleration_m_s2 = 100\n"};
    std::mt19937 engine_;
    std::vector<Axis> axes_;
    std::vector<Clearance> clearances_;
};

/// Speeds at which motions exist and at which none do, of machines that allow the same ones, do not overlap.
void expect_same_speeds(const MachineSolution& one, const MachineSolution& other, const std::string& what) {
    EXPECT_EQ(one.certificate.verdict == Verdict::infeasible,
              other.certificate.verdict == Verdict::infeasible)
        << what;
    if (one.impossible_above) {
        EXPECT_LE(other.speed, *one.impossible_above * (1.0 + 1e-6)) << what;
    }
    if (other.impossible_above) {
        EXPECT_LE(one.speed, *other.impossible_above * (1.0 + 1e-6)) << what;
    }
    if (one.certificate.verdict == Verdict::optimal && other.certificate.verdict == Verdict::optimal) {
        EXPECT_NEAR(other.speed / one.speed, 1.0, 1.01e-3) << what;
    }
}

TEST(MachineTrials, RandomMachinesAgreeWithRedundantTwins) {
    const int machines = testing_support::scenes_to_try(3, 200);
    int open = 0;
    const auto solved = [&](const RandomMachine& random, const RandomMachine::Twin& twin) {
        MachineSolution solution = solve_machine(random.made(twin));
        if (solution.certificate.verdict == Verdict::feasible) {
            ++open;  // what is not decided is said
            EXPECT_FALSE(solution.notes.empty()) << twin.name;
        }
        return solution;
    };
    for (int seed = 0; seed < machines; ++seed) {
        const RandomMachine random(static_cast<unsigned>(seed));
        const MachineSolution alone = solved(random, {});
        for (const RandomMachine::Twin& twin : {RandomMachine::Twin{"idle axis", false, false, true},
                                                RandomMachine::Twin{"lift doubled", true, false, false},
                                                RandomMachine::Twin{"turning point at rest", false, true}})
            expect_same_speeds(alone, solved(random, twin), fmt::format("machine {}, {}", seed, twin.name));
    }
    EXPECT_LE(open, machines / 25) << "of " << 4 * machines << " solves";
}

}  // namespace machine_trials_test
}  // namespace camopt
