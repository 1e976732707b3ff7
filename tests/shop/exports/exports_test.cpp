// SPDX-License-Identifier: MIT
// Every file of a solution by its name: those that it has, what they hold, and refusals.
#include "report/exports/exports.hpp"

#include "core/errors.hpp"
#include "core/text/text_file.hpp"
#include "input/loading/load_scene.hpp"
#include "shop/exports/workshop_options.hpp"
#include "shop/plc/plc_export.hpp"
#include "shop/sheet/sheet_files.hpp"
#include "shop/step/step_file.hpp"
#include "studies/solve/solve.hpp"
#include "tests/report/prescribed_disk.hpp"
#include "tests/report/sample_solution.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace camopt {
namespace exports_test {

using testing_support::prescribed_disk_toml;
using testing_support::refusal;
using testing_support::says;

/// With a drawing.
Solution disk(const std::string& more = "") {
    return solve(scene_of_toml(std::string("title = \"Lever cam\"") + prescribed_disk_toml +
                               "[drawing]\nbore_mm = 10\nthickness_mm = 4\n" + more));
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
        if (name.starts_with("twincat7.")) {  // of a cubic the jerk jumps
            EXPECT_THROW((void)exported_file(solution, name), InputError);
            continue;
        }
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
    const ExportOptions options{
        .settings = {
            {"thickness_mm", "5"}, {"spindle_rpm", "4321"}, {"cutter_in", "0.25"}, {"points", "37"}}};
    EXPECT_NE(exported_file(solution, "drawing.svg", options), exported_file(solution, "drawing.svg"));
    const std::string program = exported_file(solution, "cam.nc", options);
    EXPECT_TRUE(says(program, "4321"));
    EXPECT_TRUE(says(program, "diameter 6.35 mm"));
    EXPECT_NE(exported_file(solution, "codesys.st", options), exported_file(solution, "codesys.st"));
}

TEST(Exports, WrongOptionsAreRefusedByTheirKey) {
    const Solution solution = disk();
    const auto refused = [&](std::vector<std::pair<std::string, std::string>> settings) {
        return refusal([&] { (void)exported_file(solution, "codesys.st", {.settings = settings}); });
    };
    EXPECT_TRUE(says(refused({{"points", "1"}}), "points: found 1; allowed: an integer from 2 to 100000"));
    EXPECT_TRUE(says(refused({{"cutter_mm", "-3"}}), "cutter_mm: found -3; allowed: a number > 0"));
    EXPECT_TRUE(says(refused({{"direction", "down"}}), "direction: found \"down\"; allowed: \"climb\""));
    EXPECT_TRUE(says(refused({{"cuter_mm", "3"}}), "cuter_mm: "));
    EXPECT_TRUE(says(refused({{"cutter_mm", "3"}, {"cutter_in", "0.1"}}), "cutter_"));
}

/// Every row, in every unit: what is written is stored, in SI.
TEST(Exports, EveryOptionIsStored) {
    int read = 0;
    for (const KeyRow& row : workshop_rows())
        for (const Spelling& spelling : row.spellings) {
            const bool is_text = row.type == KeyType::text, is_number = row.type == KeyType::number;
            const std::string word = !row.choices.empty()           ? std::string(row.choices.back())
                                     : is_text                      ? "some file.toml"
                                     : row.type == KeyType::boolean ? "true"
                                                                    : "7";
            const std::pair<std::string, std::string> setting(row.key(spelling), word);
            const WorkshopOptions options = workshop_options({&setting, 1});
            const std::optional<KeyValue> value = row.place->value(options, {});
            ASSERT_TRUE(value) << setting.first;
            if (is_number) {
                EXPECT_DOUBLE_EQ(std::get<double>(*value), 7.0 * spelling.factor) << setting.first;
            }
            if (is_text) {
                EXPECT_EQ(std::get<std::string>(*value), word) << setting.first;
            }
            ++read;
        }
    EXPECT_GT(read, 60);
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
