// SPDX-License-Identifier: MIT
// Arcs and cutter compensation: where the cutter's centre goes, by hand.
#include "shop/nc/cutter_compensation.hpp"

#include "core/errors.hpp"
#include "tests/shop/nc/nc_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace camopt {
namespace cutter_compensation_test {

struct PlanePath : ::testing::Test {
    std::unique_ptr<Machine> machine = plane_milling_machine();
    PostProcessor post = generic_post(*machine);
    [[nodiscard]] std::vector<NcMove> moves(const std::string& text) const {
        return read_nc_text("G21 G17 G90 G94\nG0 X0 Y0 Z0\n" + text, *machine, post);
    }
    /// The text's first move after the rapid, at this share, mm.
    [[nodiscard]] Eigen::Vector2d along(const std::string& text, double share) const {
        const auto read = moves(text);
        return 1e3 * values_along(read[0].values, read[1], share).head<2>();
    }
    [[nodiscard]] std::vector<NcMove> centre(const std::string& text) const {
        return compensated(moves(text), 2e-3);
    }
};

void expect_at(const NcMove& move, double x, double y) {
    EXPECT_NEAR(move.values(0), 1e-3 * x, 1e-12) << "line " << move.line;
    EXPECT_NEAR(move.values(1), 1e-3 * y, 1e-12) << "line " << move.line;
}

TEST_F(PlanePath, ArcsGoRoundTheirCentre) {
    const Eigen::Vector2d counter = along("G3 X20 Y0 I10 J0 F10\n", 0.25);
    EXPECT_NEAR(counter.x(), 10.0 - 10.0 * std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(counter.y(), -10.0 * std::sqrt(0.5), 1e-9);
    const Eigen::Vector2d clockwise = along("G2 X20 Y0 I10 J0 F10\n", 0.5);
    EXPECT_NEAR(clockwise.x(), 10.0, 1e-9);
    EXPECT_NEAR(clockwise.y(), 10.0, 1e-9);
    const Eigen::Vector2d whole = along("G2 X0 Y0 I10 J0 F10\n", 0.5);
    EXPECT_NEAR(whole.x(), 20.0, 1e-9);
    const auto read = moves("G2 X0 Y0 I10 J0 F10\n");
    EXPECT_NEAR(linear_length(read[0].values, read[1]), 0.02 * std::numbers::pi, 1e-12);
}

// A machine whose X counts the other way sees the mirror image of what is printed.
TEST_F(PlanePath, MirroredAxisReversesArcs) {
    const std::string text = "G41 D1 G1 X-10 F10\nG3 X-20 Y10 I0 J10\nG40 G1 X-30\n";
    EXPECT_EQ(moves(text)[1].compensation, CompensationSide::left);
    post.axes["x"].sign = -1;
    const auto read = moves("G41 D1 G1 X-10 F10\nG3 X-20 Y10 I0 J10\nG40 G1 X-30\n");
    EXPECT_EQ(read[1].compensation, CompensationSide::right);
    EXPECT_TRUE(read[2].arc->clockwise);
    EXPECT_NEAR(read[2].arc->center.x(), 0.01, 1e-12);
}

TEST_F(PlanePath, OuterCornersAreRolledAround) {
    const auto path = centre("G42 D1 G1 X10 F10\nG1 Y10\nG40 G1 X20\n");  // a left turn, the cutter is right
    ASSERT_EQ(path.size(), 5u);
    expect_at(path[1], 10.0, -2.0);
    ASSERT_TRUE(path[2].arc);
    EXPECT_FALSE(path[2].arc->clockwise);
    EXPECT_NEAR(path[2].arc->center.x(), 0.01, 1e-15);
    expect_at(path[2], 12.0, 0.0);
    expect_at(path[3], 12.0, 10.0);
    expect_at(path[4], 20.0, 10.0);
}

TEST_F(PlanePath, InnerCornersAreCutShort) {
    const auto path = centre("G41 D1 G1 X10 F10\nG1 Y10\nG40 G1 X20\n");
    ASSERT_EQ(path.size(), 4u);
    expect_at(path[1], 8.0, 2.0);
    expect_at(path[2], 8.0, 10.0);
}

TEST_F(PlanePath, ArcsKeepTheirCentre) {
    const auto path = centre("G41 D1 G1 X10 F10\nG3 X15 Y5 I0 J5\nG1 Y10\nG40 G1 X20\n");
    ASSERT_EQ(path.size(), 5u);
    expect_at(path[1], 10.0, 2.0);
    expect_at(path[2], 13.0, 5.0);
    EXPECT_NEAR(path[2].arc->center.y(), 5e-3, 1e-15);
    expect_at(path[3], 13.0, 10.0);
}

TEST_F(PlanePath, RefusesWhatNoControlTakes) {
    for (const char* const bad :
         {"G41 D1 G3 X10 Y10 I0 J10 F10\nG40 G1 X20\n",               // begins with an arc
          "G41 D1 G1 X10 F10\nG3 X11 Y1 I0 J1\nG1 Y9\nG40 G1 X20\n",  // the cutter is larger than the arc
          "G41 D1 G1 X10 F10\nG1 Y1\nG1 X0\nG40 G1 Y9\n",             // and than the slot
          "G41 D1 G1 X10 F10\nG1 Y10 Z1\nG40 G1 X20\n", "G41 G1 X10 F10\n", "G41 D1 D2 G1 X10 F10\n",
          "G1 X5 D1 F10\n", "G41 D1 G0 X10\n", "G18\nG3 X10 Y10 I0 J10 F10\n", "G3 X10 Y10 F10\n",
          "G3 X10 Y10 R10 F10\n", "G3 X10 Y10.1 I0 J10 F10\n", "G1 X10 I5 F10\n",
          "G41 D1 G1 X10 F10\nG40 G3 X20 Y10 I0 J10\n"})
        EXPECT_THROW(static_cast<void>(centre(bad)), InputError) << bad;
    const auto four = rotary_table_machine();
    EXPECT_THROW(static_cast<void>(read_nc_text("G21 G17 G90\nG0 X0 Y0 Z0 A0\nG41 D1 G1 X10 F10\n", *four,
                                                generic_post(*four))),
                 InputError);
}

}  // namespace cutter_compensation_test
}  // namespace camopt
