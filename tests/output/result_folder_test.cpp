// SPDX-License-Identifier: MIT
#include "output/result_folder.hpp"

#include "core/errors.hpp"
#include "output/text_file.hpp"
#include "sample_solution.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

namespace camopt {
namespace {

std::set<std::string> names_in(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

TEST(ResultFolder, IsCreatedAndHoldsExactlyItsFiles) {
    const test::TemporaryFolder folder;
    const std::filesystem::path out = folder.path() + "/a/b";
    const auto written = write_result_folder(out, test::sample_solution());
    EXPECT_EQ(written.size(), 5U);
    EXPECT_EQ(names_in(out), (std::set<std::string>{"certificate.json", "motion.csv", "motion.svg",
                                                    "report.md", "result.json"}));
}

TEST(ResultFolder, ALaterRunWithoutACurveLeavesNoOldOne) {
    const test::TemporaryFolder folder;
    write_result_folder(folder.path(), test::sample_solution());
    write_result_folder(folder.path(), test::infeasible_solution());
    EXPECT_EQ(names_in(folder.path()),
              (std::set<std::string>{"certificate.json", "report.md", "result.json"}));
}

TEST(ResultFolder, ACamComesWithItsProfile) {
    const test::TemporaryFolder folder;
    const auto written = write_result_folder(folder.path(), test::cam_solution(), {}, {.points = 90});
    EXPECT_EQ(names_in(folder.path()),
              (std::set<std::string>{"certificate.json", "motion.csv", "motion.svg", "profile.csv",
                                     "profile.svg", "profile_diagrams.svg", "report.md", "result.json"}));
    EXPECT_EQ(written.back().filename(), "result.json");
    const std::string table = read_text_file(folder.path() + "/profile.csv");
    EXPECT_NEAR(static_cast<double>(std::count(table.begin(), table.end(), '\n')), 95.0, 6.0);
}

TEST(ResultFolder, ADrawingIsWrittenOnlyWhereItIsAskedFor) {
    const test::TemporaryFolder folder;
    write_result_folder(folder.path(), test::cam_solution(), {}, {.dxf = true});
    EXPECT_TRUE(names_in(folder.path()).contains("profile.dxf"));
    write_result_folder(folder.path(), test::cam_solution());
    EXPECT_FALSE(names_in(folder.path()).contains("profile.dxf"));  // it would not be this cam's
    write_result_folder(folder.path(), test::sample_solution());
    EXPECT_EQ(names_in(folder.path()).size(), 5U);
}

TEST(ResultFolder, RefusesAFile) {
    const test::TemporaryFolder folder;
    const std::string path = folder.path() + "/taken";
    write_text_file(path, "x");
    try {
        write_result_folder(path, test::sample_solution());
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("it is a file, not a folder"), std::string::npos);
    }
    EXPECT_EQ(read_text_file(path), "x");
}

TEST(TextFile, ReplacesInOneStepAndLeavesNothingElse) {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.path() + "/file";
    write_text_file(path, "first");
    write_text_file(path, "second");
    EXPECT_EQ(read_text_file(path), "second");
    EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"file"});
    EXPECT_THROW(write_text_file(folder.path() + "/missing/file", "x"), InputError);
}

}  // namespace
}  // namespace camopt
