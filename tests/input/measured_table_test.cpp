// SPDX-License-Identifier: MIT
// Tables of measured motions: columns by their names, faults with their lines, and scenes that stand alone.
#include "core/errors.hpp"
#include "input/scene_parts.hpp"
#include "input/scene_reader.hpp"
#include "profiles/factory/cam_formulas.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace camopt::input {
namespace measured_table_test {

const KnownNames known = {.laws = {"modified_sine"}, .solvers = {}, .cam_formulas = cam_formulas};

std::string refusal(const std::string& text) {
    try {
        (void)measured_table_of(text, "m.csv");
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
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
        "m.csv:1: found the columns \"angle\", \"s_mm\"; allowed: one of them named theta_deg or theta_rad");
    EXPECT_EQ(refusal("theta_deg,s_cm\n"),
              "m.csv:1: found the columns \"theta_deg\", \"s_cm\"; allowed: one of them "
              "named s_mm, s_in, s_m, s_deg or s_rad");
    EXPECT_EQ(refusal("theta_deg,theta_rad,s_mm\n"),
              "m.csv:1: found two columns, theta_deg and theta_rad; allowed: one of theta_deg or theta_rad");
    EXPECT_EQ(refusal("theta_deg,s_mm\n0,0\n1\n"),
              "m.csv:3: found 1 cells; allowed: 2, as the first line names columns");
    EXPECT_EQ(refusal("theta_deg,s_mm\n0,0\n\n1,nan\n"),
              "m.csv:4: found \"nan\" in the column s_mm; allowed: a finite number");
    EXPECT_EQ(
        refusal("theta_deg;s_mm\n0;0\n1;0,5\n"),
        "m.csv:3: found \"0,5\" in the column s_mm; allowed: a finite number, written with a decimal point");
    EXPECT_EQ(refusal("theta_deg,s_mm\n0,0\n2,1\n2,3\n"),
              "m.csv:4: found theta_deg = 2 after 2; allowed: ascending angles");
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
        try {
            KnownNames here = known;
            here.folder = folder_;
            (void)read_scene(scene, "s.toml", here);
        } catch (const InputError& error) {
            std::string words = error.what();
            const std::string path = (folder_ / "m.csv").string();
            if (words.starts_with(path)) words.replace(0, path.size(), "m.csv");
            return words;
        }
        return "accepted";
    }

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
              "s.toml:3:18: measured.table: found displacements in deg where the lift is a length; "
              "allowed: s_mm, s_in or s_m");
}

TEST_F(MeasuredScene, TextWithoutFolderReadsNoFile) {
    try {
        (void)read_scene(scene, "s.toml", known);
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "s.toml:3:18: measured.table: found a file name in a scene that was not read from a "
                     "file; allowed: "
                     "the numbers, theta_deg and s_mm, or a scene file that names its table");
    }
}

TEST_F(MeasuredScene, ItsTextIsSelfContained) {
    write("s.toml", scene);
    const Scene given = read_scene_file(folder_ / "s.toml", known);
    const std::string alone = whole_scene_text(folder_ / "s.toml");
    EXPECT_EQ(alone.find("table ="), std::string::npos) << alone;
    const Scene again = read_scene(alone, "s.toml", known);
    ASSERT_TRUE(again.measured);
    EXPECT_EQ(again.measured->angle, given.measured->angle);
    EXPECT_EQ(again.measured->displacement, given.measured->displacement);
    EXPECT_EQ(again.measured->name, "m.csv");
    write("plain.toml", "motion.type = \"DRD\" # as given\nobjective.jerk = 1\n");
    EXPECT_EQ(whole_scene_text(folder_ / "plain.toml"),
              "motion.type = \"DRD\" # as given\nobjective.jerk = 1\n");
}

}  // namespace measured_table_test
}  // namespace camopt::input
