// SPDX-License-Identifier: MIT
// Plane cams as programs and solids.
#include "shop/disk/disk_export.hpp"

#include "core/errors.hpp"
#include "shop/nc/spoiled_programs.hpp"
#include "tests/shop/disk/harmonic_disk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace camopt {
namespace disk_export_test {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double millimetre = 1e-3;

using testing_support::harmonic_disk;

TEST(DiskNc, IsCheckedAlongTheContour) {
    const auto machine = plane_milling_machine();
    DiskNcOptions options;
    options.milling.full_depth = true;
    options.chord_tolerance = 2e-6;
    for (const double stock : {0.0, 0.3 * millimetre}) {
        options.stock = stock;
        const CheckedProgram result = checked_program(
            *machine, generic_post(*machine), disk_nc_work(harmonic_disk(10.0 * millimetre), options));
        EXPECT_TRUE(result.poses.within_rounding);
        EXPECT_LE(result.chord_deviation, options.chord_tolerance);
        ASSERT_EQ(result.surfaces.size(), 1u);
        const double tolerance = options.chord_tolerance + result.poses.tip_rounding;
        EXPECT_NEAR(result.surfaces[0].check.least_stock, stock, tolerance);
        EXPECT_NEAR(result.surfaces[0].check.stock, stock, tolerance);
        EXPECT_NE(nc_check_text(result).find("the cam's contour"), std::string::npos);
    }
}

TEST(NcRapids, CorruptedWordIsRefusedForDisk) {
    const auto machine = plane_milling_machine();
    const ProfileShape shape = harmonic_disk(10.0 * millimetre);
    DiskNcOptions options;
    options.milling.full_depth = true;
    options.chord_tolerance = 1e-4;
    options.gouge_tolerance = 5e-4;  // many programs: the rapids are what matters
    NcWork work = disk_nc_work(shape, options);
    work.task.surfaces.clear();
    for (const FeedMode mode : {FeedMode::inverse_time, FeedMode::per_minute}) {
        PostProcessor post = generic_post(*machine);
        post.feed_mode = mode;
        const CheckedProgram right = checked_program(*machine, post, work);
        ASSERT_EQ(right.fault(), "");
        test::Spoiling how;
        how.heights = {-21.0, -1.0, 0.0, 1.9, -200.0};
        how.across = {"X", "Y"};
        const auto spoiled = test::spoiled_programs(right.program.text, how);
        EXPECT_GT(spoiled.size(), 15u);
        for (const test::SpoiledProgram& program : spoiled)
            EXPECT_NE(test::refusal_of(program.text, right, *machine, post, work), "") << program.kind;
    }
}

// A block left out, and blocks as rapids: the contour itself.
TEST(NcRapids, ContourBlocksAreNotRapids) {
    const auto machine = plane_milling_machine();
    const PostProcessor post = generic_post(*machine);
    const ProfileShape shape = harmonic_disk(10.0 * millimetre);
    DiskNcOptions options;
    options.milling.full_depth = true;
    options.chord_tolerance = 1e-4;
    const NcWork work = disk_nc_work(shape, options);
    const CheckedProgram right = checked_program(*machine, post, work);
    ASSERT_EQ(right.fault(), "");
    for (const test::TextLine& line : test::lines_of(right.program.text)) {
        if (line.words.rfind("G1 ", 0) != 0) continue;
        const std::string rapid = "G0" + line.words.substr(2);
        EXPECT_NE(
            test::refusal_of(test::with_line(right.program.text, line, rapid), right, *machine, post, work),
            "")
            << rapid;
        EXPECT_NE(
            test::refusal_of(test::with_line(right.program.text, line, ""), right, *machine, post, work), "")
            << line.words;
    }
}

// A cutter of 60 mm in hollows of 20 mm: not a program that is handed out.
TEST(NcGouge, LargeCutterInHollowIsRefused) {
    const auto machine = plane_milling_machine();
    ProfileShape shape = harmonic_disk(0.0);
    shape.at = [](double theta) {
        const double r = 50.0 * millimetre, wave = 4.0 * millimetre;
        const double radius = r + wave * std::cos(6.0 * theta), slope = -6.0 * wave * std::sin(6.0 * theta);
        const Eigen::Vector2d out(std::cos(theta), std::sin(theta)), along(-out.y(), out.x());
        MechanismPoint point;
        point.contact << radius * out, 0.0;
        point.normal << (radius * out - slope * along).normalized(), 0.0;
        point.regularity = 1.0;
        return point;
    };
    DiskNcOptions options;
    options.milling.full_depth = true;
    options.chord_tolerance = 1e-5;
    options.cutter_diameter = 30.0 * millimetre;
    EXPECT_EQ(checked_program(*machine, generic_post(*machine), disk_nc_work(shape, options)).fault(), "");
    options.cutter_diameter = 60.0 * millimetre;
    const CheckedProgram gouges =
        checked_program(*machine, generic_post(*machine), disk_nc_work(shape, options));
    EXPECT_NE(gouges.fault().find("enters the finished cam"), std::string::npos) << gouges.fault();
    EXPECT_NE(nc_check_text(gouges).find("REFUSED: line "), std::string::npos);
}

// A title is no way to write a move.
TEST(NcComments, ATitleStaysAComment) {
    const auto machine = plane_milling_machine();
    PostProcessor post = generic_post(*machine);
    post.header = {"%", "O1 ({title})"};
    DiskNcOptions options;
    options.milling.full_depth = true;
    options.chord_tolerance = 1e-4;
    options.title = "cam)\nG0 Z-50 (\x1b[31m";
    const CheckedProgram program =
        checked_program(*machine, post, disk_nc_work(harmonic_disk(10.0 * millimetre), options));
    EXPECT_EQ(program.fault(), "");
    EXPECT_EQ(program.program.text.find("\nG0 Z-50"), std::string::npos);
    EXPECT_EQ(program.program.text.find('\x1b'), std::string::npos);
}

TEST(DiskExport, RefusesWhatCannotBeMade) {
    const auto machine = plane_milling_machine();
    const PostProcessor post = generic_post(*machine);
    EXPECT_THROW(
        static_cast<void>(checked_program(*machine, post, disk_nc_work(harmonic_disk(0.01, 2.0), {}))),
        InputError);
    DiskNcOptions options;
    options.thickness = 0.0;
    EXPECT_THROW(
        static_cast<void>(checked_program(*machine, post, disk_nc_work(harmonic_disk(0.01), options))),
        InputError);
    const auto refused = [&](auto change) {
        DiskNcOptions wrong;
        change(wrong);
        EXPECT_THROW(
            static_cast<void>(checked_program(*machine, post, disk_nc_work(harmonic_disk(0.01), wrong))),
            InputError);
    };
    refused([](DiskNcOptions& wrong) { wrong.blank.radius = 0.045; });  // the cam reaches 50 mm
    refused([](DiskNcOptions& wrong) { wrong.blank.upper = -0.001; });
    refused([](DiskNcOptions& wrong) { wrong.blank.lower = -0.019; });
    refused([](DiskNcOptions& wrong) { wrong.blank.allowance = -0.001; });
    refused([](DiskNcOptions& wrong) { wrong.clearance = -0.001; });
    refused([](DiskNcOptions& wrong) { wrong.clearance = 0.001; });
    refused([](DiskNcOptions& wrong) { wrong.safe_distance = 0.0; });
    refused([](DiskNcOptions& wrong) { wrong.gouge_tolerance = 0.0; });
}

}  // namespace disk_export_test
}  // namespace camopt
