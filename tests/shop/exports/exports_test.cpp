// SPDX-License-Identifier: MIT
// Every file of a solution by its name: those that it has, what they hold, and refusals.
#include "shop/exports/exports.hpp"

#include "core/errors.hpp"
#include "core/text/text_file.hpp"
#include "core/units.hpp"
#include "input/loading/load_scene.hpp"
#include "shop/plc/plc_export.hpp"
#include "shop/sheet/sheet_files.hpp"
#include "shop/step/step_file.hpp"
#include "studies/solve/solve.hpp"
#include "tests/output/sample_solution.hpp"
#include "tests/output/temporary_folder.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace camopt {
namespace exports_test {

using testing_support::refusal;
using testing_support::says;

/// A disk cam of laws alone: solved at once.
Solution disk(const std::string& more = "") {
    return solve(scene_of_toml(R"(
title = "Lever cam"
[motion]
type = "program"
lift_mm = 8
speed_rpm = 300
segments = [{ kind = "law", law = "cycloidal", angle_deg = 120, to_mm = 8 }, { kind = "dwell", angle_deg = 60 },
            { kind = "law", law = "cycloidal", angle_deg = 120, to_mm = 0 }, { kind = "dwell", angle_deg = 60 }]
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = 20
roller_radius_mm = 6
[drawing]
bore_mm = 10
thickness_mm = 4
)" + more));
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

TEST(Exports, EveryNameGivesAFile) {
    const Solution solution = disk();
    const std::vector<std::string> names = export_names(solution);
    for (const char* const name : {"report.html", "motion.csv", "codesys.st", "profile.dxf", "drawing.pdf",
                                   "cam.step", "cam.stl", "cam.nc", "cam_nc_check.txt"})
        EXPECT_TRUE(has(names, name)) << name;
    std::vector<std::string> available;
    for (const std::string& name : names) {
        const bool left_out =
            (name == "drawing.pdf" && !pdf_available()) || (name.ends_with(".step") && !step_available());
        if (left_out) {
            EXPECT_THROW((void)exported_file(solution, name), UnavailableError) << name;
        } else {
            available.push_back(name);
        }
    }
    const test::TemporaryFolder folder;
    for (const std::filesystem::path& file : write_exports(folder.path(), solution, available))
        EXPECT_GT(std::filesystem::file_size(file), 100U) << file;
}

TEST(Exports, OptionsReachTheFiles) {
    const Solution solution = disk();
    ExportOptions options;
    options.plate.thickness = 5.0 * units::millimetre;
    options.nc.spindle_rpm = 4321.0;
    options.nc.cutter_diameter = 6.0 * units::millimetre;
    options.plc.points = 37;
    EXPECT_NE(exported_file(solution, "drawing.svg", options), exported_file(solution, "drawing.svg"));
    const std::string program = exported_file(solution, "cam.nc", options);
    EXPECT_TRUE(says(program, "4321"));
    EXPECT_TRUE(says(program, "diameter 6 mm"));
    EXPECT_NE(exported_file(solution, "codesys.st", options), exported_file(solution, "codesys.st"));
    options.plc.points = 1;
    EXPECT_TRUE(says(refusal([&] { (void)exported_file(solution, "codesys.st", options); }),
                     "points: found 1; allowed: 2 to"));
}

TEST(Exports, UnknownNameIsRefusedWithChoices) {
    const std::string words = refusal([] { (void)exported_file(test::program_solution(), "cam.nc"); });
    EXPECT_TRUE(says(words, "file: found \"cam.nc\"; allowed for this solution: report.html"));
    EXPECT_FALSE(has(export_names(test::infeasible_solution()), "motion.csv"));
    EXPECT_TRUE(has(export_names(test::infeasible_solution()), "report.html"));
}

TEST(Exports, FolderGetsAllFilesOrNone) {
    const test::TemporaryFolder folder;
    const std::filesystem::path place = folder.path();
    const Solution solution = disk();
    const std::vector<std::string> names = {"codesys.st", "drawing.svg"};
    const auto written = write_exports(place / "made", solution, names);
    ASSERT_EQ(written.size(), 2U);
    EXPECT_EQ(read_text_file(place / "made/codesys.st"), exported_file(solution, "codesys.st"));
    EXPECT_THROW(
        write_exports(place / "none", solution, std::vector<std::string>{"codesys.st", "nothing.txt"}),
        InputError);
    EXPECT_FALSE(std::filesystem::exists(place / "none/codesys.st"));
}

}  // namespace exports_test
}  // namespace camopt
