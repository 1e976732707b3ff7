// SPDX-License-Identifier: MIT
// The reader of G-code: what it understands, and that it refuses what it does not.
#include "shop/nc/nc_reader.hpp"

#include "core/units.hpp"
#include "tests/shop/nc/nc_samples.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace nc_reader_test {

struct Reading : ::testing::Test {
    std::unique_ptr<Machine> machine = rotary_table_machine();
    PostProcessor post = generic_post(*machine);
    [[nodiscard]] std::vector<NcMove> moves(std::string_view text) const {
        return read_nc_text(text, *machine, post);
    }
};

TEST_F(Reading, MovesOfAShortProgram) {
    const auto read = moves(
        "%\nO1234 (a title; with a semicolon)\nN10 G21 G90 G94 G17 G54\nS2000 M3\nG0 Z50.\n"
        "G0X10.5 Y-2 A90 (over)\nG1 Z-3.25 F100 ; down\nG93\nX11 A91.5 F120\r\nG94\nG0 Z50\nM30\n%\n");
    ASSERT_EQ(read.size(), 4u);
    EXPECT_TRUE(read[0].rapid);
    EXPECT_EQ(read[0].line, 6);
    EXPECT_NEAR(read[0].values(0), 0.0105, 1e-17);
    EXPECT_NEAR(read[0].values(2), 0.05, 1e-17);
    EXPECT_FALSE(read[1].rapid);
    EXPECT_NEAR(read[1].values(2), -0.00325, 1e-17);
    EXPECT_NEAR(read[2].values(0), 0.011, 1e-17);
    EXPECT_NEAR(read[2].values(1), -0.002, 1e-17);
    EXPECT_NEAR(read[2].values(3), 91.5 * units::degree, 1e-15);
    EXPECT_NEAR(read[2].seconds, 0.5, 1e-15);
    EXPECT_EQ(read[1].seconds, 0.0);
    EXPECT_TRUE(read[3].rapid);
}

TEST_F(Reading, InchesAndSigns) {
    post.axes["x"].sign = -1;
    post.axes["x"].offset = 0.001;
    const auto read = moves("G20 G90\nG0 X1 Y0 Z0 A0\n");
    ASSERT_EQ(read.size(), 1u);
    EXPECT_NEAR(read[0].values(0), -(0.0254 - 0.001), 1e-17);
}

TEST_F(Reading, RefusesWhatItWouldHaveToGuess) {
    const std::string start = "G21 G90 G94\nG0 X0 Y0 Z0 A0\n";
    for (const char* const bad : {"G2 X1 I1 F10", "G91", "G43 H1", "G1 X1 W2 F10", "G1 X F10", "G1 X1 Q2 F10",
                                  "G1 X1e3 F10", "G0 X1 (open", "G1 X1", "G93\nG1 X1", "G1 X1 F0",
                                  "G1 X1 F-5", "G0 G1 X1 F5", "x1", "G1 X- F10", "G1 X[#1] F5"})
        EXPECT_THROW(static_cast<void>(moves(start + bad + "\n")), InputError) << bad;
    EXPECT_EQ(moves(start + "G1 X1 F10\n").size(), 2u);
    EXPECT_THROW(static_cast<void>(moves("G90\nG0 X0 Y0 Z0 A0\n")), InputError);      // no unit
    EXPECT_THROW(static_cast<void>(moves("G21\nG0 X0 Y0 Z0 A0\n")), InputError);      // no G90
    EXPECT_THROW(static_cast<void>(moves("G21 G90\nX0 Y0 Z0 A0\n")), InputError);     // no G0
    EXPECT_THROW(static_cast<void>(moves("G21 G90\nG1 X0 Y0 Z0 F5\n")), InputError);  // no A yet
}

TEST_F(Reading, RefusesOtherCoordinatesUnderWay) {
    const std::string start = "G21 G90 G94 G54\nG0 X0 Y0 Z50 A0\n";
    for (const char* const bad : {"G55", "G20", "G21", "M6 T2", "G1 X1 X2 F10"})
        EXPECT_THROW(static_cast<void>(moves(start + bad + "\nG0 Z60\n")), InputError) << bad;
    // Modes count for the whole block they stand in.
    const auto read = moves("G90\nX254 Y0 Z0 A0 G21 G0\n");
    ASSERT_EQ(read.size(), 1u);
    EXPECT_NEAR(read[0].values(0), 0.254, 1e-16);
}

TEST_F(Reading, TravelKeepsMovesBeforeAllAxesKnown) {
    const auto read = read_nc_travel("G21 G90\nG0 Z50\nG0 X1\nG0 Y2 A3\n", *machine, post);
    ASSERT_EQ(read.size(), 3u);
    EXPECT_NEAR(read[0].values(2), 0.05, 1e-17);
    EXPECT_TRUE(std::isnan(read[0].values(0)));
    EXPECT_TRUE(std::isnan(read[1].values(3)));
    EXPECT_TRUE(read[2].values.allFinite());
}

TEST_F(Reading, NamesTheLine) {
    using namespace testing_support;
    EXPECT_TRUE(says(refusal([&] { (void)moves("G21 G90\n\nG0 X0\nG5 X1\n"); }), "line 4"));
}

}  // namespace nc_reader_test
}  // namespace camopt
