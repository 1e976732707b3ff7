// SPDX-License-Identifier: MIT
// Tables of measured motions: columns by their names, faults with their lines, and scenes that stand alone.
#include "core/errors.hpp"
#include "core/units.hpp"
#include "input/inspected_table.hpp"
#include "input/scene_parts.hpp"
#include "input/scene_reader.hpp"
#include "profiles/factory/cam_formulas.hpp"
#include "tests/support/refusal.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace camopt::input {
namespace measured_table_test {

using testing_support::says;

const KnownNames known = {.laws = {"modified_sine"}, .solvers = {}, .cam_formulas = cam_formulas};

std::string refusal(const std::string& text, const TableForm& form = {}) {
    return testing_support::refusal([&] { (void)measured_table_of(text, "m.csv", form); });
}

TEST(MeasuredTable, FindsColumnsAmongOthers) {
    const MeasuredTable table = measured_table_of(
        "\xEF\xBB\xBF# a remark\r\n\r\nforce_n; s_in ;\"theta_rad\"\r\n7;0.5;1e-1\r\n8;+0.75;0.2\r\n",
        "m.csv");
    EXPECT_EQ(table.theta_key, "theta_rad");
    EXPECT_EQ(table.s_key, "s_in");
    EXPECT_EQ(table.theta, (std::vector<double>{0.1, 0.2}));
    EXPECT_EQ(table.s, (std::vector<double>{0.5, 0.75}));
    EXPECT_EQ(table.lines, (std::vector<int>{4, 5}));
    EXPECT_EQ(table.s_unit.factor, 0.0254);
}

TEST(MeasuredTable, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(refusal(""),
              "m.csv:1: found no line at all; allowed: a line that names the columns, theta_deg and "
              "s_mm, and rows of numbers");
    EXPECT_EQ(
        refusal("angle,s_mm\n"),
        "m.csv:1: found 2 columns, of these only s_mm; allowed: one of them named theta_deg, theta_rad, "
        "theta_crank_deg or "
        "crank_deg, or step_deg in [measured], or columns = [\"theta_deg\", \"s_mm\"] in [measured], in the "
        "order "
        "of the file");
    EXPECT_EQ(
        refusal("theta_deg,s_cm\n"),
        "m.csv:1: found 2 columns, of these only theta_deg; allowed: one of them "
        "named s_mm, s_in, s_m, s_deg or s_rad, or columns = [\"theta_deg\", \"s_mm\"] in [measured], in the "
        "order of the file");
    EXPECT_EQ(
        refusal("theta_deg,s_mm\n0,0\n1\n"),
        "m.csv:3: found 1 cells; allowed: 2, as the first line names columns, or # before a line that is no "
        "row");
    EXPECT_EQ(refusal("theta_deg,s_mm\n0,0\n\n1,nan\n"),
              "m.csv:4: found \"nan\" in the column s_mm; allowed: a finite number, or # before the line");
    EXPECT_EQ(
        refusal("theta_deg;s_mm\n0;0\n1;0,5\n"),
        "m.csv:3: found \"0,5\" in the column s_mm; allowed: a finite number, written with a decimal point; "
        "with a comma where [measured] has decimal = \",\"");
    EXPECT_EQ(
        refusal("theta_deg,s_mm\n0,0\n2,1\n2,3\n"),
        "m.csv:4: found theta_deg = 2 after 2; allowed: angles that ascend, or descend, all along the table");
    EXPECT_EQ(
        refusal("0,0\n1,1\n"),
        "m.csv:1: found numbers where the columns are named; allowed: a line such as theta_deg,s_mm, or "
        "columns = [\"theta_deg\", \"s_mm\"] in [measured]");
}

TEST(MeasuredTable, ReadsOtherForms) {
    const MeasuredTable bare = measured_table_of("0\n0.5\n1\n", "m.csv", {{"s_in"}, true});
    EXPECT_EQ(bare.s, (std::vector<double>{0, 0.5, 1}));
    EXPECT_TRUE(bare.theta.empty());
    EXPECT_TRUE(bare.theta_key.empty());
    const TableForm comma{{"theta_deg", "-", "s_mm"}, false, ','};
    const MeasuredTable german = measured_table_of("Winkel;Kraft;Hub\n0;1;0\n1,5;2;0,25\n", "m.csv", comma);
    EXPECT_EQ(german.theta, (std::vector<double>{0, 1.5}));
    EXPECT_EQ(german.s, (std::vector<double>{0, 0.25}));
    EXPECT_EQ(german.lines, (std::vector<int>{2, 3}));
    const MeasuredTable crank = measured_table_of("crank_deg\ts_mm\n20\t1\n10\t2\n", "m.csv");
    EXPECT_EQ(crank.theta_key, "theta_crank_deg");
    EXPECT_EQ(crank.theta, (std::vector<double>{20, 10}));
    const MeasuredTable joint = measured_table_of("theta_deg,theta_rad,s_mm\n0,0,0\n1,1,2\n1,1,2\n", "m.csv");
    EXPECT_EQ(joint.theta_key, "theta_deg");
    EXPECT_EQ(joint.lines, (std::vector<int>{2, 3}));
    EXPECT_EQ(
        refusal("1,0;0.5\n", {{"theta_deg", "s_mm"}, false, ','}),
        "m.csv:1: found \"0.5\" in the column s_mm; allowed: a finite number, written with a decimal comma");
    EXPECT_EQ(refusal("theta_deg,s_mm\n", {{}, true}),
              "m.csv:1: found the column theta_deg together with measured.step; allowed: one of the two");
    EXPECT_EQ(
        refusal("1,2\n", {{"s_mm"}, true}),
        "m.csv:1: found 2 cells; allowed: 1, as measured.columns names columns, or # before a line that is "
        "no row");
}

class MeasuredScene : public ::testing::Test {
 protected:
    void SetUp() override {
        // Tests run beside one another.
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  (std::string("camopt_measured_") +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(folder_);
        write("m.csv", table);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    [[nodiscard]] std::string refusal_of(const std::string& csv) const {
        write("m.csv", csv);
        KnownNames here = known;
        here.folder = folder_;
        std::string words = testing_support::refusal([&] { (void)read_scene(scene, "s.toml", here); });
        const std::string path = (folder_ / "m.csv").string();
        if (words.starts_with(path)) words.replace(0, path.size(), "m.csv");
        return words;
    }

    /// The same table in another form must give the same motion.
    void expect_same(const std::string& csv, const std::string& measured) const {
        write("m.csv", csv);
        write("s.toml", scene + measured);
        const Scene read = read_scene_file(folder_ / "s.toml", known);
        const Scene alone = read_scene(whole_scene_text(folder_ / "s.toml"), "s.toml", known);
        for (const Scene* one : {&read, &alone}) {
            const MeasuredMotion& motion = one->measured.value();
            std::vector<double> inside, lifts;
            for (std::size_t k = 0; k < motion.angle.size(); ++k)
                if (motion.angle[k] > -1e-9 && motion.angle[k] < one->motion.rise + 1e-9) {
                    inside.push_back(motion.angle[k] / units::degree);
                    lifts.push_back(1e3 * motion.displacement[k]);
                }
            ASSERT_EQ(inside.size(), 9u) << measured;
            for (std::size_t k = 0; k < 9; ++k) {
                EXPECT_NEAR(inside[k], 10.0 * static_cast<double>(k), 1e-9) << measured;
                EXPECT_NEAR(lifts[k], expected[k], 1e-12) << measured;
            }
            EXPECT_TRUE(std::ranges::is_sorted(motion.angle));
        }
    }

    const std::vector<double> expected = {0, 0.5, 1.5, 3, 5, 7, 8.5, 9.5, 10};
    std::filesystem::path folder_;
    const std::string table =
        "theta_deg,s_mm\n0,0\n10,0.5\n20,1.5\n30,3\n40,5\n50,7\n60,8.5\n70,9.5\n80,10\n";
    const std::string scene =
        "motion = { type = \"DRD\", rise_deg = 80, lift_mm = 10 }\nobjective.jerk = 1\nmeasured.table = "
        "\"m.csv\"\n";
};

TEST_F(MeasuredScene, IsReadFromItsFolder) {
    write("s.toml", scene);
    const Scene read = read_scene_file(folder_ / "s.toml", known);
    ASSERT_TRUE(read.measured);
    EXPECT_EQ(read.measured->angle.size(), 9u);
    EXPECT_DOUBLE_EQ(read.measured->displacement[5], 7e-3);
    EXPECT_EQ(read.measured->name, "m.csv");
}

TEST_F(MeasuredScene, EveryFormGivesTheSameMotion) {
    const std::string lifts = "0\n0.5\n1.5\n3\n5\n7\n8.5\n9.5\n10\n";
    expect_same(table, "");
    expect_same(lifts, "measured.columns = [\"s_mm\"]\nmeasured.step_deg = 10\n");
    expect_same(lifts,
                "measured.columns = [\"s_mm\"]\nmeasured.step_deg = 20\nmeasured.angles = \"crank\"\n");
    expect_same(lifts,
                "measured.columns = [\"s_mm\"]\nmeasured.step_crank_deg = 20\nmeasured.angles = \"crank\"\n");
    expect_same(
        "angle;lift\n-80;0\n-70;0,5\n-60;1,5\n-50;3\n-40;5\n-30;7\n-20;8,5\n-10;9,5\n0;10\n",
        "measured.columns = [\"theta_deg\", \"s_mm\"]\nmeasured.decimal = \",\"\nmeasured.zero = \"nose\"\n");
    expect_same("crank_deg,s_mm\n220,10\n200,9.5\n180,8.5\n160,7\n140,5\n120,3\n100,1.5\n80,0.5\n60,0\n",
                "measured.zero = { deg = -30 }\n");
    // One revolution from the nose on: the dwell at the top, what is between, the dwell at the bottom, the
    // rise.
    std::string turn = "theta_deg,s_mm\n";
    for (int k = 0; k <= 36; ++k)
        turn += fmt::format("{},{}\n", 10 * k,
                            k < 10   ? 10.0
                            : k < 28 ? 0.0
                                     : expected[static_cast<std::size_t>(k - 28)]);
    expect_same(turn, "measured.zero = \"nose\"\n");
}

TEST_F(MeasuredScene, NoseIsMiddleOfTopDwell) {
    write("s.toml",
          "objective.jerk = 1\n[motion]\ntype = \"program\"\nlift_mm = 10\n"
          "segments = [{ kind = \"spline\", angle_deg = 100, to = 1 }, { kind = \"dwell\", angle_deg = 40 }, "
          "{ kind = \"spline\", angle_deg = 100, to = 0 }, { kind = \"dwell\", angle_deg = 120 }]\n"
          "[measured]\ntable = \"m.csv\"\nzero = \"nose\"\n");
    std::string turn = "theta_deg,s_mm\n";  // 72 rows: 0 to 355 deg
    for (int k = 0; k < 72; ++k) {
        const double away = std::min(5.0 * k, 360.0 - 5.0 * k);
        turn += fmt::format("{},{}\n", 5 * k, 10 * std::clamp((120.0 - away) / 100.0, 0.0, 1.0));
    }
    write("m.csv", turn);
    const MeasuredMotion motion = read_scene_file(folder_ / "s.toml", known).measured.value();
    ASSERT_EQ(motion.angle.size(), 72u);
    EXPECT_NEAR(motion.angle.front() / units::degree, 5.0, 1e-9);
    EXPECT_NEAR(motion.angle.back() / units::degree, 360.0, 1e-9);
    EXPECT_NEAR(motion.displacement[23], 10e-3, 1e-12);  // 120 deg
}

TEST_F(MeasuredScene, TableFaultsNameTheirLines) {
    EXPECT_EQ(refusal_of("theta_deg,s_mm\n0,0\n1,1\n"),
              "m.csv: theta_deg: found 2 rows; allowed: 8 to 1000000 rows");
    std::string low = table;
    low.replace(low.find("80,10\n"), 6, "80,9\n");
    EXPECT_EQ(
        refusal_of(low),
        "m.csv:10: s_mm: found 9 mm at 80 deg; allowed: 10 mm, to 0.5 mm: what the scene requires at 80 deg");
    std::string shorter = table;
    shorter.replace(shorter.find("80,10\n"), 6, "75,10\n");
    EXPECT_EQ(refusal_of(shorter),
              "m.csv:10: theta_deg: found 75 deg; allowed: 80 deg, the end of the motion");
    std::string swings = table;
    swings.replace(0, 14, "theta_deg,s_deg");
    EXPECT_EQ(refusal_of(swings),
              "s.toml:3:18: measured.table: found the unit \"deg\" where the lift is a length; "
              "allowed: s_mm, s_in or s_m");
}

TEST_F(MeasuredScene, TextWithoutFolderReadsNoFile) {
    EXPECT_EQ(testing_support::refusal([&] { (void)read_scene(scene, "s.toml", known); }),
              "s.toml:3:18: measured.table: found a file name in a scene that was not read from a file; "
              "allowed: the numbers, theta_deg and s_mm, or a scene file that names its table");
}

TEST_F(MeasuredScene, ItsTextIsSelfContained) {
    write("s.toml", scene);
    const Scene given = read_scene_file(folder_ / "s.toml", known);
    const std::string alone = whole_scene_text(folder_ / "s.toml");
    EXPECT_FALSE(says(alone, "table ="));
    const Scene again = read_scene(alone, "s.toml", known);
    ASSERT_TRUE(again.measured);
    EXPECT_EQ(again.measured->angle, given.measured->angle);
    EXPECT_EQ(again.measured->displacement, given.measured->displacement);
    EXPECT_EQ(again.measured->name, "m.csv");
    write("plain.toml", "motion.type = \"DRD\" # as given\nobjective.jerk = 1\n");
    EXPECT_EQ(whole_scene_text(folder_ / "plain.toml"),
              "motion.type = \"DRD\" # as given\nobjective.jerk = 1\n");
}

/// Eight rows of two cells each.
std::string eight(const std::string& header, const std::string& first, const std::string& second) {
    std::string text = header + "\n";
    for (int i = 0; i < 8; ++i) text += fmt::format("{}{}{}\n", i, first, second);
    return text;
}

std::string inspected_refusal(const std::string& text) {
    return testing_support::refusal([&] { (void)inspected_table_of(text, "m.csv"); });
}

TEST(InspectedTable, ReadsDisplacementsInAnySpelling) {
    const InspectedTable table =
        inspected_table_of(eight("# gauge\ncrank_deg;s_in;x_mm", "0,5", ";1,5;0"), "m.csv");
    EXPECT_FALSE(table.points);
    EXPECT_FALSE(table.is_angle);
    EXPECT_NEAR(table.rows[3].x(), 15.25 * units::degree, 1e-15);
    EXPECT_NEAR(table.rows[3].y(), 1.5 * units::inch, 1e-15);
    EXPECT_EQ(table.lines[3], 6);
    EXPECT_TRUE(inspected_table_of(eight("theta_rad,s_deg", "", ",1.5"), "m.csv").is_angle);
}

TEST(InspectedTable, ReadsPointsOfTheCam) {
    const InspectedTable plane = inspected_table_of(eight("y_mm\tx_in", ",5", "\t1"), "m.csv");
    EXPECT_TRUE(plane.points);
    EXPECT_NEAR(plane.rows[3].x(), 0.0254, 1e-15);
    EXPECT_NEAR(plane.rows[3].y(), 3.5e-3, 1e-15);
    EXPECT_EQ(plane.lines[3], 5);
    const InspectedTable polar = inspected_table_of(eight("theta_deg,r_mm", "0", ",40"), "m.csv");
    EXPECT_TRUE(polar.points);
    EXPECT_NEAR(polar.rows[7].x(), 0.04 * std::cos(70.0 * units::degree), 1e-15);
    EXPECT_NEAR(polar.rows[7].y(), 0.04 * std::sin(70.0 * units::degree), 1e-15);
}

/// A scene of others can name any file: what is no table is not shown to them.
TEST(MeasuredTable, RepeatsNoLinesOfOtherFiles) {
    const std::string secret = "root:x:0:0:root:/root:/bin/sh daily\nkey = secret\n";
    for (const std::string& found :
         {inspected_refusal(secret), refusal(secret), inspected_refusal("secret-host\n"),
          refusal("secret-host\n"), refusal("secret,daily\nother,text\n"),
          refusal("secret words\n", {.columns = {"theta_deg", "s_mm"}}),
          refusal("1,secret\n", {.columns = {"theta_deg", "s_mm"}})})
        for (const char* const word : {"root", "secret", "daily", "host"}) EXPECT_FALSE(says(found, word));
}

TEST(InspectedTable, SaysWhatIsWrongAndWhere) {
    const std::string allowed =
        "theta_deg and s_mm of the follower, or x_mm and y_mm, or r_mm and theta_deg of the cam";
    EXPECT_EQ(inspected_refusal("angle,lift\n0,1\n"),
              "m.csv:1: found 2 columns, none of these; allowed: " + allowed);
    EXPECT_EQ(inspected_refusal("\n0.5,1\n1,2\n"),
              "m.csv:2: found 2 columns, none of these; allowed: " + allowed);
    EXPECT_EQ(inspected_refusal("x_mm,z_mm\n0,1\n"),
              "m.csv:1: found 2 columns, none of these; allowed: " + allowed);
    EXPECT_EQ(inspected_refusal("x_mm,y_mm\n0,1\n0,one\n"),
              "m.csv:3: found \"one\" in the column y_mm; allowed: a finite number, or # before the line");
    EXPECT_EQ(inspected_refusal("theta_deg,s_mm\n0,1\n1,1\n"), "m.csv: found 2 rows; allowed: at least 8");
    EXPECT_TRUE(says(testing_support::refusal([] { (void)read_inspected_table("/nowhere/m.csv"); }),
                     "allowed: a CSV file with the columns " + allowed));
}

}  // namespace measured_table_test
}  // namespace camopt::input
