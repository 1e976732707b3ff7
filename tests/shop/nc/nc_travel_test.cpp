// SPDX-License-Identifier: MIT
// Every move, rapids too, against blank and finished cam: by hand-written programs.
#include "shop/nc/nc_travel.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace camopt {
namespace nc_travel_test {

using units::millimetre;

/// A round cam of 40 mm radius, 20 mm thick, from a blank of 50 mm; a cutter of 12 mm.
struct RoundCam : ::testing::Test {
    std::unique_ptr<Machine> machine = plane_milling_machine();
    PostProcessor post = generic_post(*machine);
    std::unique_ptr<FinishedCam> cam =
        plane_finished_cam({[](double theta) {
                                const Eigen::Vector2d out(std::cos(theta), std::sin(theta));
                                return ContourPoint{40.0 * millimetre * out, out};
                            },
                            {0.0, 2.0 * std::numbers::pi}});
    NcTravelTask task{{50.0 * millimetre, -20.0 * millimetre, 0.0},
                      6.0 * millimetre,
                      cam.get(),
                      2.0 * millimetre,
                      0.01 * millimetre};

    [[nodiscard]] std::string fault(const std::string& moves) const {
        return check_travel(read_nc_travel("G21 G90 G94\n" + moves, *machine, post), *machine, task).fault;
    }
};

TEST_F(RoundCam, RapidsKeepTheirDistance) {
    const std::string above = "G0 Z20\nG0 X70 Y0\n";
    EXPECT_EQ(fault(above + "G0 Z2\nG0 X-70\n"), "");
    EXPECT_NE(fault(above + "G0 Z1.9\nG0 X-70\n"), "");
    EXPECT_EQ(fault(above + "G0 Z-21\nG0 Y50\n"), "");      // beside the blank
    EXPECT_NE(fault(above + "G0 Z-21\nG0 X-70 Y1\n"), "");  // through it, with both ends outside
    EXPECT_NE(fault(above + "G0 Z-30\nG0 X0\n"), "");       // under it: the shank goes through
    EXPECT_EQ(fault(above + "G0 Z-21\nG0 X58.1\n"), "");
    EXPECT_NE(fault(above + "G0 Z-21\nG0 X57.9\n"), "");
    EXPECT_NE(fault(above + "G0 X0\nG0 Z-1\n"), "");
}

// A control may run X before Z.
TEST_F(RoundCam, RapidsAreNotAssumedStraight) {
    const std::string above = "G0 Z20\nG0 X70 Y0\nG0 Z-21\n";
    EXPECT_NE(fault(above + "G0 X-40 Z200\n"), "");
    EXPECT_EQ(fault(above + "G0 Z200\nG0 X-40\n"), "");
}

TEST_F(RoundCam, TheFirstMovesCountToo) {
    EXPECT_NE(fault("G0 X70 Y0\nG0 Z20\n"), "");  // across, at whatever height the tool is
    EXPECT_NE(fault("G0 X70 Y0 Z20\n"), "");
    EXPECT_NE(fault("G0 Z1\n"), "");
    EXPECT_NE(fault("G0 Z-21\nG0 X70 Y0\n"), "");
    EXPECT_EQ(fault("G0 Z2\nG0 X70\nG0 Y0\n"), "");
    EXPECT_NE(fault("G0 Z20\nG0 X70\nG0 Z-5\n"), "");  // Y is not known yet
}

TEST_F(RoundCam, FeedsStayOutsideFinishedCam) {
    const std::string beside = "G0 Z20\nG0 X46 Y0\nG0 Z2\nG1 Z-21 F100\n";
    EXPECT_EQ(fault(beside + "G1 Z2\nG0 Z20\n"), "");
    EXPECT_NE(fault(beside + "G1 Y-1\nG1 X-46\n"), "");  // straight through the cam
    EXPECT_EQ(fault(beside + "G1 Y1\nG1 X45.99 Y1\n"), "");
    EXPECT_NE(fault(beside + "G1 X45.98\n"), "");
    EXPECT_NE(fault("G0 Z20\nG0 X0 Y0\nG0 Z2\nG1 Z-9 F100\n"), "");  // into its middle
    // A chord that enters between its ends by 0.02 mm; by 0.009 mm.
    const auto chord = [&](double enters) {
        const double half = std::acos((46.0 - enters) / 46.0), x = 46.0 * std::cos(half),
                     y = 46.0 * std::sin(half);
        return fault(beside + "G1 X" + std::to_string(x) + " Y" + std::to_string(y) + "\nG1 Y" +
                     std::to_string(-y) + "\n");
    };
    EXPECT_NE(chord(0.02), "");
    EXPECT_EQ(chord(0.009), "");
}

// The dangerous spot of a rapid that only just touches is a part in 1e5 of its length: no grid of samples
// would find it.
TEST_F(RoundCam, AGrazingRapidIsFound) {
    task.least_distance = 1e-6 * millimetre;
    const std::string start = "G0 Z100\nG0 X5000 Y56\nG0 Z-21\n";
    EXPECT_NE(fault("G0 Z100\nG0 X5000 Y55.999999\nG0 Z-21\nG0 X-5000\n"), "");
    EXPECT_EQ(fault("G0 Z100\nG0 X5000 Y56.0001\nG0 Z-21\nG0 X-5000\n"), "");
}

TEST_F(RoundCam, FaultNamesTheLine) {
    const std::string found = fault("G0 Z20\nG0 X0 Y0\nG0 Z-1\n");
    EXPECT_EQ(found.substr(0, 8), "line 4: ") << found;
}

TEST_F(RoundCam, RefusesWrongTasks) {
    EXPECT_THROW(static_cast<void>(fault("")), InputError);
    for (double NcTravelTask::*const number :
         {&NcTravelTask::cutter_radius, &NcTravelTask::least_distance, &NcTravelTask::most_depth}) {
        NcTravelTask wrong = task;
        wrong.*number = 0.0;
        EXPECT_THROW(wrong.validate(), InputError);
    }
    NcTravelTask wrong = task;
    wrong.cam = nullptr;
    EXPECT_THROW(wrong.validate(), InputError);
}

// A long drum across the table: turning it moves no side nearer, tilting it does.
TEST(TurningRapids, CarryTheBlankWithThem) {
    struct NoCam final : FinishedCam {
        double depth(const ToolPose&, double) override { return -1.0; }
        Eigen::Vector3d towards_flank(const ToolPose&) override { return Eigen::Vector3d::Zero(); }
    } none;
    const NcTravelTask task{{0.03, -0.1, 0.1}, 0.005, &none, 0.002, 1e-5};
    const auto fault = [&](const Machine& machine, const std::string& moves) {
        return check_travel(read_nc_travel("G21 G90\n" + moves, machine, generic_post(machine)), machine,
                            task)
            .fault;
    };
    const auto four = rotary_table_machine(), five = table_tilting_machine(0.0);
    EXPECT_EQ(fault(*four, "G0 Z50\nG0 X0 Y0 A0\nG0 Z33\nG0 A5000\n"), "");
    EXPECT_NE(fault(*four, "G0 Z50\nG0 X0 Y0 A0\nG0 Z31\n"), "");
    const std::string start = "G0 Z110\nG0 X0 Y0 C0 B0\n";
    EXPECT_EQ(fault(*five, start + "G0 Z33\nG0 C300\n"), "");
    EXPECT_NE(fault(*five, start + "G0 Z33\nG0 B60\n"), "");
    EXPECT_NE(fault(*five, start + "G0 Z80\nG0 B100\nG0 B180\n"), "");  // the end face passes, both ends free
    EXPECT_NE(fault(*five, "G0 Z50\nG0 X0 Y0 C0 B0\n"), "");            // free at B0, not from any other B
}

}  // namespace nc_travel_test
}  // namespace camopt
