// SPDX-License-Identifier: MIT
// What programs leave on the flanks and what they take too much: the numbers of paper 001's example.
#include "core/errors.hpp"
#include "shop/nc/nc_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace surface_check_test {

using test::degree;
using test::millimetre;

constexpr double tip_beyond = 1.0 * millimetre;  // so that the sections lie on the cutter's side

std::vector<Eigen::Vector3d> flank_points(double height, int flank, const std::vector<double>& angles) {
    const RollerPath roller = test::rotating_roller();
    std::vector<Eigen::Vector3d> points;
    for (const double theta : angles) {
        const RollerPose at = roller(theta, height);
        points.push_back(at.center + flank * 8.0 * millimetre * at.normal);
    }
    return points;
}

/// The program for these cam angles, printed with nine decimals and read back.
std::vector<NcMove> moves_of(const Machine& machine, const CutterLocation& location,
                             const std::vector<double>& angles) {
    const PostProcessor post = test::fine_post(machine);
    const ToolPath path = cutter_path(test::rotating_roller(), location);
    return read_nc_text(nc_program(machine, post, test::job_of(test::poses_at(path, angles))).text, machine,
                        post);
}

// Rise of 180 deg in so many blocks, roller-equal cutter, section h = 20 mm.
TEST(SurfaceCheck, ChordErrorsOfPaper001) {
    const auto machine = table_tilting_machine(test::z_offset);
    CutterLocation location = test::rotating_location(16.0 * millimetre);
    location.tip_beyond = tip_beyond;
    const std::vector<std::pair<int, double>> claimed{{180, 1.5e-3}, {360, 3.8e-4}, {720, 9.5e-5}};
    for (const auto& [blocks, chord_mm] : claimed) {
        const auto moves = moves_of(*machine, location, test::even(180.0 * degree, 360.0 * degree, blocks));
        double gouge = 0.0, stock = 0.0;
        for (const int flank : {1, -1}) {
            const auto points = flank_points(20.0 * millimetre, flank,
                                             test::even(181.0 * degree, 359.0 * degree, 4 * 178 * 4));
            const NcSurfaceCheck check =
                check_surface(moves, *machine, {16.0 * millimetre, 40.0 * millimetre}, points);
            gouge = std::max(gouge, check.gouge);
            stock = std::max(stock, check.stock);
        }
        const double half_digit = std::pow(10.0, std::floor(std::log10(chord_mm)) - 1.0) * 0.5;
        EXPECT_NEAR(gouge / millimetre, chord_mm, half_digit) << blocks;
        EXPECT_NEAR(stock / millimetre, chord_mm, half_digit) << blocks;
    }
}

// At the blocks themselves an equal cutter touches both flanks: as fine as the program is printed.
TEST(SurfaceCheck, EqualCutterIsExactAtBlocks) {
    const auto machine = table_tilting_machine(test::z_offset);
    CutterLocation location = test::rotating_location(16.0 * millimetre);
    location.tip_beyond = tip_beyond;
    const PostProcessor post = generic_post(*machine);
    const std::vector<double> angles = test::even(0.0, test::full_turn, 360);
    const ToolPath path = cutter_path(test::rotating_roller(), location);
    const std::vector<ToolPose> poses = test::poses_at(path, angles);
    const auto moves = read_nc_text(nc_program(*machine, post, test::job_of(poses)).text, *machine, post);
    const NcPoseCheck poses_check = check_poses(moves, *machine, post, poses);
    EXPECT_TRUE(poses_check.within_rounding);
    const RollerPath roller = test::rotating_roller();
    double worst = 0.0;
    std::size_t block = 0;
    for (const NcMove& move : moves) {
        if (move.rapid || block == angles.size()) continue;  // the last feed leads out
        const ToolPose found = machine->pose(move.values);
        for (const double height : {0.0, 10.0 * millimetre, 20.0 * millimetre})
            for (const int flank : {1, -1}) {
                const RollerPose at = roller(angles[block], height);
                const Eigen::Vector3d point = at.center + flank * 8.0 * millimetre * at.normal;
                const Eigen::Vector3d from_tip = point - found.tip;
                const double distance = (from_tip - from_tip.dot(found.axis) * found.axis).norm();
                worst = std::max(worst, std::abs(distance - 8.0 * millimetre));
            }
        ++block;
    }
    EXPECT_EQ(block, angles.size());
    EXPECT_LT(worst, poses_check.tip_rounding);
    EXPECT_GT(worst, 1e-3 * poses_check.tip_rounding);
}

// A cutter of 10 mm steered at h = 20 mm leaves up to 0.069 mm at h = 0 and gouges nowhere.
TEST(SurfaceCheck, SmallerCutterLeavesStock) {
    const auto machine = table_tilting_machine(test::z_offset);
    for (const int flank : {1, -1}) {
        CutterLocation location = test::rotating_location(10.0 * millimetre, 0.0, flank);
        location.tip_beyond = tip_beyond;
        const std::vector<double> blocks = test::even(0.0, test::full_turn, 2880);
        const auto moves = moves_of(*machine, location, blocks);
        const std::vector<double> inside = test::even(2.0 * degree, 358.0 * degree, 356);
        const CutterShape cutter{10.0 * millimetre, 40.0 * millimetre};
        double stock = 0.0;
        for (const double height : {0.0, 5.0 * millimetre, 10.0 * millimetre, 15.0 * millimetre}) {
            const NcSurfaceCheck check =
                check_surface(moves, *machine, cutter, flank_points(height, flank, inside));
            EXPECT_LT(check.gouge / millimetre, 1e-4) << height;
            stock = std::max(stock, check.stock);
            if (height == 0.0) {
                EXPECT_NEAR(check.stock / millimetre, 0.069, 0.0005) << flank;
            }
        }
        EXPECT_NEAR(stock / millimetre, 0.069, 0.0005);
        const NcSurfaceCheck steered =
            check_surface(moves, *machine, cutter, flank_points(20.0 * millimetre, flank, inside));
        EXPECT_LT(steered.stock / millimetre, 1e-4);
        EXPECT_LT(steered.gouge / millimetre, 1e-4);
    }
}

TEST(SurfaceCheck, RequestedStockIsLeft) {
    const auto machine = table_tilting_machine(test::z_offset);
    CutterLocation location = test::rotating_location(10.0 * millimetre, 0.2 * millimetre);
    location.tip_beyond = tip_beyond;
    const auto moves = moves_of(*machine, location, test::even(0.0, test::full_turn, 1440));
    const NcSurfaceCheck check =
        check_surface(moves, *machine, {10.0 * millimetre, 40.0 * millimetre},
                      flank_points(20.0 * millimetre, 1, test::even(2.0 * degree, 358.0 * degree, 178)));
    EXPECT_NEAR(check.least_stock / millimetre, 0.2, 1e-4);
    EXPECT_NEAR(check.stock / millimetre, 0.2, 1e-4);
}

// A cutter driven 0.05 mm too deep into the flank.
TEST(SurfaceCheck, GougeIsFound) {
    const auto machine = table_tilting_machine(test::z_offset);
    CutterLocation location = test::rotating_location(10.0 * millimetre);
    location.tip_beyond = tip_beyond;
    const auto moves = moves_of(*machine, location, test::even(0.0, test::full_turn, 1440));
    const NcSurfaceCheck check =
        check_surface(moves, *machine, {10.1 * millimetre, 40.0 * millimetre},
                      flank_points(20.0 * millimetre, 1, test::even(2.0 * degree, 358.0 * degree, 178)));
    EXPECT_NEAR(check.gouge / millimetre, 0.05, 1e-4);
}

TEST(BlockAngles, KeepTheChordTolerance) {
    const auto machine = table_tilting_machine(test::z_offset);
    const ToolPath path = cutter_path(test::rotating_roller(), test::rotating_location(16.0 * millimetre));
    const FollowerMotion motion = test::rotating_motion();
    BlockOptions options;
    options.working_length = 20.0 * millimetre;
    std::size_t before = 0;
    for (const double tolerance : {1e-5, 1e-6, 1e-7}) {
        options.chord_tolerance = tolerance;
        const BlockAngles blocks = block_angles(path, *machine, motion.breakpoints, options);
        EXPECT_LE(blocks.chord_deviation, tolerance);
        EXPECT_GT(blocks.chord_deviation, 0.2 * tolerance);
        EXPECT_GT(blocks.theta.size(), before);
        before = blocks.theta.size();
        for (const double knot : motion.breakpoints)
            EXPECT_TRUE(std::find(blocks.theta.begin(), blocks.theta.end(), knot) != blocks.theta.end());
        // Between the quarters, where the subdivision did not look.
        for (std::size_t i = 1; i < blocks.theta.size(); ++i) {
            const Eigen::VectorXd first = machine->values(path(blocks.theta[i - 1]));
            const Eigen::VectorXd last =
                nearest_turn(*machine, machine->values(path(blocks.theta[i])), first);
            for (const double share : {0.1, 0.37, 0.61, 0.9}) {
                const double theta = blocks.theta[i - 1] + share * (blocks.theta[i] - blocks.theta[i - 1]);
                EXPECT_LT((machine->pose(first + share * (last - first)).tip - path(theta).tip).norm(),
                          1.02 * tolerance);
            }
        }
    }
}

// Position error of the tip: 1.548e-3, 3.87e-4, 9.67e-5 mm; the part along the normal is what the paper's
// example counts as chord error (ChordErrorsOfPaper001).
TEST(BlockAngles, CountsEvenWithSecondOrderErrors) {
    const auto machine = table_tilting_machine(test::z_offset);
    const ToolPath path = cutter_path(test::rotating_roller(), test::rotating_location(16.0 * millimetre));
    const std::vector<double> rise{180.0 * degree, 360.0 * degree};
    BlockOptions options;
    for (const auto& [count, expected_mm] :
         std::vector<std::pair<int, double>>{{180, 1.548e-3}, {360, 3.870e-4}, {720, 9.675e-5}}) {
        options.count = count;
        const BlockAngles blocks = block_angles(path, *machine, rise, options);
        ASSERT_EQ(blocks.theta.size(), static_cast<std::size_t>(count) + 1);
        EXPECT_NEAR(blocks.chord_deviation / millimetre, expected_mm, 1e-3 * expected_mm);
    }
    const std::vector<double> wrong{1.0, 1.0};
    EXPECT_THROW(static_cast<void>(block_angles(path, *machine, wrong, options)), InputError);
    options.count = 0;
    EXPECT_THROW(static_cast<void>(block_angles(path, *machine, rise, options)), InputError);
}

}  // namespace surface_check_test
}  // namespace camopt
