// SPDX-License-Identifier: MIT
// Post-processor files: what they set, what they are refused for, what it does to the text.
#include "shop/nc/post_processor.hpp"

#include "core/errors.hpp"
#include "core/text/parsing.hpp"
#include "core/units.hpp"
#include "shop/nc/nc_program.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/source_folder.hpp"
#include "tests/support/written_rows.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace post_processor_test {

using testing_support::refusal;
using testing_support::says;

PostProcessor five_axes() {
    return generic_post(*table_tilting_machine(0.0));
}

TEST(PostProcessor, EveryKeyOfAFile) {
    const PostProcessor post = post_of_text(R"(
name = "shop"
unit = "inch"
feed = "per_minute"
linear_decimals = 5
angle_decimals = 3
feed_decimals = 1
modal = false
first_block = 100
block_step = 5
comment_begin = ";"
comment_end = ""
header = ["O77", "G54"]
footer = ["M2"]
spindle_on = "M13 S{spindle_rpm}"
[axes.x]
letter = "U"
sign = -1
offset_mm = 2.5
[axes.tilt]
letter = "A"
offset_deg = 90
)",
                                            "shop.toml", five_axes());
    EXPECT_EQ(post.name, "shop");
    EXPECT_EQ(post.unit, LengthUnit::inch);
    EXPECT_EQ(post.feed_mode, FeedMode::per_minute);
    EXPECT_EQ(post.linear_decimals, 5);
    EXPECT_EQ(post.angle_decimals, 3);
    EXPECT_EQ(post.feed_decimals, 1);
    EXPECT_FALSE(post.modal);
    EXPECT_EQ(post.first_block, 100);
    EXPECT_EQ(post.block_step, 5);
    EXPECT_EQ(post.comment_begin + post.comment_end, ";");
    EXPECT_EQ(post.header, (std::vector<std::string>{"O77", "G54"}));
    EXPECT_EQ(post.footer, std::vector<std::string>{"M2"});
    EXPECT_EQ(post.spindle_on, "M13 S{spindle_rpm}");
    EXPECT_EQ(post.axes.at("x").letter, "U");
    EXPECT_EQ(post.axes.at("x").sign, -1);
    EXPECT_NEAR(post.axes.at("x").offset, 0.0025, 1e-18);
    EXPECT_NEAR(post.axes.at("tilt").offset, 90.0 * units::degree, 1e-15);
    EXPECT_EQ(post.axes.at("rotary").letter, "C");
}

// The examples of docs/nc.md.
TEST(PostProcessor, FilesOfTheManual) {
    const std::string folder = source_folder() + "/docs/posts/";
    const PostProcessor inch = read_post(folder + "table_tilting_inch.toml", five_axes());
    EXPECT_EQ(inch.unit, LengthUnit::inch);
    EXPECT_EQ(inch.axes.at("rotary").sign, -1);
    EXPECT_NEAR(inch.axes.at("tilt").offset, 90.0 * units::degree, 1e-15);
    const PostProcessor millimetres =
        read_post(folder + "rotary_table_mm.toml", generic_post(*rotary_table_machine()));
    EXPECT_EQ(millimetres.linear_decimals, 3);
    EXPECT_EQ(millimetres.axes.at("rotary").letter, "A");
}

TEST(PostProcessor, RowsAreReadAsWritten) {
    const auto samples_of = [](const KeyRow& row) -> std::vector<KeyValue> {
        std::vector<KeyValue> samples;
        for (const std::string_view choice : row.choices)
            samples.push_back(row.type == KeyType::integer ? KeyValue(integer_in(choice).value())
                                                           : KeyValue(std::string(choice)));
        if (!samples.empty()) return samples;
        if (row.type == KeyType::integer) return {0LL, 2LL};
        if (row.type == KeyType::boolean) return {false, true};
        if (row.type == KeyType::number) return {0.25, -3.0};
        if (row.type == KeyType::texts) return {std::vector<std::string>{"G54", "M2"}};
        return {std::string("U")};
    };
    const auto file_of = [](const KeyRow& row, const std::string& line) {
        return row.table.empty() ? line : fmt::format("[{}]\n{}", row.table, line);
    };
    EXPECT_EQ(testing_support::expect_rows_read_as_written(post_rows(), five_axes(), samples_of, file_of),
              66);
}

TEST(PostProcessor, RefusesValuesByItsRows) {
    const auto refused = [](const auto& change) {
        PostProcessor post = five_axes();
        change(post);
        return refusal([&] { post.validate(); });
    };
    EXPECT_EQ(refused([](PostProcessor& post) { post.feed_decimals = 10; }),
              "post-processor: feed_decimals: found 10; allowed: an integer from 0 to 9");
    EXPECT_EQ(refused([](PostProcessor& post) { post.block_step = -1; }),
              "post-processor: block_step: found -1; allowed: an integer from 0 to 1000000000");
    EXPECT_EQ(refused([](PostProcessor& post) { post.axes["x"].sign = 2; }),
              "post-processor: axes.x.sign: found 2; allowed: 1 or -1");
    EXPECT_EQ(refused([](PostProcessor& post) { post.comment_begin = "/*"; }),
              "post-processor: comment_begin: found \"/*\"; allowed: \"(\" or \";\"");
    EXPECT_EQ(refused([](PostProcessor&) {}), "no refusal");
}

TEST(PostProcessor, RefusesWrongFiles) {
    for (const char* const bad :
         {"colour = 1", "unit = \"cm\"", "unit = 3", "linear_decimals = 10", "linear_decimals = 2.5",
          "modal = 1", "header = \"%\"", "header = [1]", "comment_begin = \"/*\"", "[axes.w]\nletter=\"W\"",
          "[axes.x]\nletter = \"XX\"", "[axes.x]\nletter = \"G\"", "[axes.x]\nletter = \"Y\"",
          "[axes.x]\nsign = 2", "[axes.x]\noffset_deg = 1", "[axes.x]\noffset_mm = nan", "axes = 3",
          "block_step = -1", "= 3"})
        EXPECT_THROW(static_cast<void>(post_of_text(bad, "bad.toml", five_axes())), InputError) << bad;
    EXPECT_EQ(refusal([] { (void)post_of_text("\nunit = \"cm\"", "bad.toml", five_axes()); }),
              "bad.toml:2:8: unit: found \"cm\"; allowed: \"mm\" or \"inch\"; did you mean 'mm'?");
    EXPECT_THROW(static_cast<void>(read_post("no/such/file.toml", five_axes())), InputError);
}

TEST(PostProcessor, ShapesTheText) {
    const auto machine = table_tilting_machine(0.0);
    PostProcessor post = generic_post(*machine);
    post.header = {"%", "O1 ({title} on {machine})"};
    post.block_step = 10;
    post.first_block = 10;
    post.linear_decimals = 3;
    post.angle_decimals = 2;
    NcJob job;
    job.title = "cam {tool}";
    job.tool = "mill (16)";
    job.spindle_rpm = 1200.0;
    job.feed = 1e-3;
    job.blank = {0.06, -0.025, 0.025};  // reaches 65 mm from the origin
    job.passes = {{"one", {{{0.05, 0, 0}, {-1, 0, 0}}, {{0.05, 0, 0.001}, {-1, 0, 0}}}}};
    const NcProgram program = nc_program(*machine, post, job);
    EXPECT_EQ(
        program.text,
        "%\n"
        "N10 O1 (cam {tool} on five axes, table turns and tilts)\n"
        "(cam {tool})\n"
        "(tool: mill  16 )\n"
        "(machine: five axes, table turns and tilts, post-processor: generic)\n"
        "(X = x in mm, Y = y in mm, Z = z in mm, C = rotary in deg, B = tilt in deg)\n"
        "(feed: G93, F = 1 / minutes of the block, plunging: G94)\n"
        "(blank: cylinder about the axis of the cam, diameter 120.000 mm, from -25.000 to 25.000 mm "
        "along it)\n"
        "(clearance plane: Z85.000, 20 mm above the blank at any angle of the table)\n"
        "(rapids stay 2 mm or more from the blank, moves into and out of it are feeds)\n"
        "(before the start: tool clear of blank and clamps, free to go straight to the clearance plane)\n"
        "(WARNING: no tool call in this program, the tool must be in the spindle and measured)\n"
        "N20 G21 G90 G94\n"
        "N30 S1200 M3\n"
        "(pass: one)\n"
        "N40 G0 Z85.000\n"
        "N50 G0 X0.000 Y0.000 C-90.00 B0.00\n"
        "N60 G0 Z62.000\n"
        "N70 G1 Z50.000 F60.000\n"
        "N80 G93\n"
        "N90 G1 X1.000 F60.000\n"
        "N100 G94\n"
        "N110 G1 Z62.000 F60.000\n"
        "N120 G0 Z85.000\n"
        "N130 M5\n"
        "N140 M30\n"
        "%\n");
    EXPECT_EQ(program.blocks, 1);
    EXPECT_NEAR(program.seconds, 1.0, 1e-12);
    post.axes["x"].sign = -1;
    post.axes["tilt"].offset = -90.0 * units::degree;
    EXPECT_TRUE(says(nc_program(*machine, post, job).text,
                     "(X = -x in mm, Y = y in mm, Z = z in mm, C = rotary "
                     "in deg, B = tilt - 90 in deg)\n"));
}

TEST(PostProcessor, RefusesLinesThatAreNotAscii) {
    const auto machine = plane_milling_machine();
    const auto refused = [&](const std::string& text) {
        return refusal([&] { (void)post_of_text(text, "post.toml", generic_post(*machine)); });
    };
    EXPECT_TRUE(says(refused("modal = true\nheader = ['%', '(Größe)']"), "post.toml:2:16: header: found"));
    EXPECT_TRUE(says(refused("tool_call = \"T1\\nM6\""), "post.toml:1:13: tool_call: found"));
    EXPECT_THROW(static_cast<void>(read_nc_travel("(Größe)\n", *machine, generic_post(*machine))),
                 InputError);
}

}  // namespace post_processor_test
}  // namespace camopt
