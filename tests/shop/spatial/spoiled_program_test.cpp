// SPDX-License-Identifier: MIT
// Programs of all machines that turn, with one word changed: the verifier refuses every one.
#include "core/errors.hpp"
#include "core/units.hpp"
#include "profiles/spatial/reference_cams.hpp"
#include "shop/nc/spoiled_programs.hpp"
#include "shop/spatial/cam_export.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace spoiled_program_test {

using test::millimetre;

constexpr double z_offset = 0.12;

struct Case {
    std::string name;
    SpatialCam cam;
    FollowerMotion motion;
    double cutter = 0.0;  ///< of the roller
};

std::vector<Case> cases() {
    return {{"barrel", test::barrel_cam(), test::barrel_motion(), 1.0},
            {"turning follower", test::rotating_cam(), test::rotating_motion(), 0.7},
            {"sliding follower", test::translating_cam(), test::translating_motion(), 0.9}};
}

NcWork work_of(const Case& one) {
    NcExportOptions options;
    options.milling.full_depth = true;
    options.cutter_diameter = one.cutter * 2.0 * one.cam[SpatialDimension::roller_radius];
    options.blocks = 120;  // coarse: what is cut does not matter here
    options.gouge_tolerance = 5e-4;
    options.z_offset = z_offset;
    options.milling.ramp_angle = 1.0;  // rad: a ramp of few blocks
    NcWork work = nc_work(one.cam, one.motion, options);
    work.task.surfaces.clear();
    return work;
}

std::vector<PostProcessor> posts_for(const Machine& machine) {
    const PostProcessor generic = generic_post(machine);
    PostProcessor inch = generic;
    inch.unit = LengthUnit::inch;
    inch.modal = false;
    inch.block_step = 10;
    inch.axes["rotary"].sign = -1;
    inch.axes["z"].offset = 3.0 * millimetre;
    PostProcessor semicolon = generic;
    semicolon.comment_begin = ";";
    semicolon.comment_end = "";
    semicolon.linear_decimals = 3;
    semicolon.axes["z"].sign = -1;
    return {generic, inch, semicolon};
}

/// Z of a height over the cam's axis, as the post prints it.
double printed(const PostProcessor& post, const Machine& machine, double height) {
    const bool five = machine.axes().size() == 5;
    const PostAxis& z = post.axes.at("z");
    return (z.sign * (height - (five ? z_offset : 0.0)) + z.offset) / metres_of(post.unit);
}

TEST(NcRapids, EveryMachineRefusesCorruptedWord) {
    for (const Case& one : cases()) {
        const auto machine = machine_for(one.cam, z_offset);
        const NcWork work = work_of(one);
        for (const PostProcessor& post : posts_for(*machine)) {
            const CheckedProgram right = checked_program(*machine, post, work);
            ASSERT_EQ(right.fault(), "") << one.name;
            test::Spoiling how;
            const double radius = work.job.blank.radius;
            // With five axes the blank's edge is up there and the cutter, beside it, may be free.
            if (machine->axes().size() == 4) how.heights.push_back(printed(post, *machine, radius - 1e-3));
            for (const double height : {radius - 0.03, 0.5 * radius, -0.5 * radius, -radius - 0.2})
                how.heights.push_back(printed(post, *machine, height));
            how.across = {"X", "Y", machine->axes().size() == 5 ? "C" : "A"};
            how.step = post.unit == LengthUnit::inch ? 0.3 : 7.0;
            const auto spoiled = test::spoiled_programs(right.program.text, how);
            EXPECT_GT(spoiled.size(), 15u);
            for (const test::SpoiledProgram& program : spoiled)
                EXPECT_NE(test::refusal_of(program.text, right, *machine, post, work), "")
                    << one.name << ", " << post.comment_begin << ", " << program.kind;
        }
    }
}

// A tilting table raises what sticks out of the blank: the plane that just clears the blank is too low.
TEST(NcRapids, TiltingTableRaisesClamps) {
    int tilting = 0;
    for (const Case& one : cases()) {
        const auto machine = machine_for(one.cam, z_offset);
        if (machine->axes().size() < 5) continue;
        const PostProcessor post = generic_post(*machine);
        const NcWork work = work_of(one);
        const CheckedProgram right = checked_program(*machine, post, work);
        const std::string& text = right.program.text;
        EXPECT_NE(text.find(" mm about its axis, at most "), std::string::npos);
        const auto lines = test::lines_of(text);
        const auto plane = std::ranges::find_if(
            lines, [](const test::TextLine& line) { return line.words.starts_with("G0 Z"); });
        const double lower = printed(post, *machine, work.job.blank.reach() + work.job.safe_distance + 1e-3);
        const std::string words = test::with_number(plane->words, "Z", lower);
        EXPECT_NE(test::refusal_of(test::with_line(text, *plane, words), right, *machine, post, work)
                      .find("clamps may reach"),
                  std::string::npos)
            << one.name;
        ++tilting;
    }
    EXPECT_GT(tilting, 0);
}

// What is farther away is not refused: the check does not cry wolf.
TEST(NcRapids, AHigherPlaneIsNotRefused) {
    for (const Case& one : cases()) {
        const auto machine = machine_for(one.cam, z_offset);
        const PostProcessor post = generic_post(*machine);
        NcWork work = work_of(one);
        const CheckedProgram right = checked_program(*machine, post, work);
        const double reach = work.job.blank.reach() + 0.1;
        for (const test::TextLine& line : test::lines_of(right.program.text)) {
            if (line.words.rfind("G0 Z", 0) != 0) continue;
            const std::string higher = test::with_number(line.words, "Z", printed(post, *machine, reach));
            EXPECT_EQ(test::refusal_of(test::with_line(right.program.text, line, higher), right, *machine,
                                       post, work),
                      "")
                << one.name << " " << line.words;
        }
    }
}

TEST(NcRapids, HeightsFollowGivenBlank) {
    const Case one = cases().front();
    const auto machine = machine_for(one.cam, 0.0);
    const PostProcessor post = generic_post(*machine);
    NcExportOptions options;
    options.milling.full_depth = true;
    options.blocks = 90;
    options.gouge_tolerance = 1e-3;
    options.blank.radius = 0.4;
    options.clearance = 0.03;
    options.safe_distance = 0.005;
    const CheckedProgram program = checked_program(*machine, post, nc_work(one.cam, one.motion, options));
    EXPECT_EQ(program.fault(), "");
    const std::string& text = program.program.text;
    EXPECT_NE(text.find("diameter 800.000 mm"), std::string::npos) << text.substr(0, 800);
    EXPECT_NE(text.find("(clearance plane: Z430.0000, 30 mm above the blank"), std::string::npos);
    EXPECT_NE(text.find("(rapids stay 5 mm or more from the blank"), std::string::npos);
    EXPECT_NE(text.find("\nG0 Z430.0000\n"), std::string::npos);
    EXPECT_NE(text.find("\nG0 Z405.0000\n"), std::string::npos);
    for (const double inside : {-0.01, 0.0, 0.004, static_cast<double>(NAN)}) {
        options.clearance = inside;
        EXPECT_THROW(
            static_cast<void>(checked_program(*machine, post, nc_work(one.cam, one.motion, options))),
            InputError)
            << inside;
    }
    options.clearance = 0.02;
    options.blank.radius = 0.05;  // the groove lies above it
    EXPECT_THROW(static_cast<void>(checked_program(*machine, post, nc_work(one.cam, one.motion, options))),
                 InputError);
}

}  // namespace spoiled_program_test
}  // namespace camopt
