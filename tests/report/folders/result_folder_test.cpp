// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "core/text/text_file.hpp"
#include "report/cam/cam_files.hpp"
#include "report/folders/result_folder_reader.hpp"
#include "tests/report/sample_solution.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <sys/resource.h>

namespace camopt {
namespace result_folder_test {

std::set<std::string> names_in(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

TEST(ResultFolder, IsCreatedWithExactlyItsFiles) {
    const test::TemporaryFolder folder;
    const std::filesystem::path out = folder.path() + "/a/b";
    const auto written = write_result_folder(out, test::sample_solution());
    EXPECT_EQ(written.size(), 6U);
    EXPECT_EQ(names_in(out), (std::set<std::string>{"certificate.json", "motion.csv", "motion.svg",
                                                    "report.md", "result.json", "tables.csv"}));
}

TEST(ResultFolder, LaterRunRemovesStaleCurve) {
    const test::TemporaryFolder folder;
    write_result_folder(folder.path(), test::sample_solution());
    write_result_folder(folder.path(), test::infeasible_solution());
    EXPECT_EQ(names_in(folder.path()),
              (std::set<std::string>{"certificate.json", "report.md", "result.json", "tables.csv"}));
}

TEST(ResultFolder, ACamComesWithItsProfile) {
    const test::TemporaryFolder folder;
    const auto written = write_result_folder(folder.path(), test::cam_solution(), {}, {.points = 90});
    EXPECT_EQ(names_in(folder.path()),
              (std::set<std::string>{"certificate.json", "forces.svg", "motion.csv", "motion.svg",
                                     "profile.csv", "profile.svg", "profile_diagrams.svg", "report.md",
                                     "result.json", "tables.csv"}));
    EXPECT_EQ(written.back().filename(), "result.json");
    const std::string table = read_text_file(folder.path() + "/profile.csv");
    EXPECT_NEAR(static_cast<double>(std::count(table.begin(), table.end(), '\n')), 95.0, 6.0);
}

TEST(ResultFolder, DrawingIsWrittenOnlyOnRequest) {
    const test::TemporaryFolder folder;
    write_result_folder(folder.path(), test::cam_solution(), {}, {.also = {{drawn_profile, "a drawing"}}});
    EXPECT_TRUE(names_in(folder.path()).contains("profile.dxf"));
    write_result_folder(folder.path(), test::cam_solution());
    EXPECT_FALSE(names_in(folder.path()).contains("profile.dxf"));  // it would not be this cam's
    write_result_folder(folder.path(), test::sample_solution());
    EXPECT_EQ(names_in(folder.path()).size(), 6U);
}

std::map<std::string, std::string> contents_of(const std::filesystem::path& folder) {
    std::map<std::string, std::string> contents;
    for (const std::string& name : names_in(folder)) contents[name] = read_text_file(folder / name);
    return contents;
}

/// Files longer than this cannot be written: what a full disk does, in the middle of a run.
class SizeLimit {
 public:
    explicit SizeLimit(std::uintmax_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~SizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
    SizeLimit(const SizeLimit&) = delete;
    SizeLimit& operator=(const SizeLimit&) = delete;
    SizeLimit(SizeLimit&&) = delete;
    SizeLimit& operator=(SizeLimit&&) = delete;

 private:
    rlimit before_{};
};

TEST(ResultFolder, InterruptedRunKeepsPreviousResults) {
    const test::TemporaryFolder first, second;
    const WriteOptions many{.points = 5000};  // so that the longest file is not the first
    write_result_folder(second.path(), test::cam_solution(), {}, many);
    const auto whole = contents_of(second.path());
    write_result_folder(first.path(), test::sample_solution());
    const auto before = contents_of(first.path());
    for (const auto& [name, text] : whole) {
        {
            const SizeLimit limit(text.size() - 1);
            EXPECT_THROW(write_result_folder(first.path(), test::cam_solution(), {}, many), InputError)
                << name;
        }
        EXPECT_EQ(contents_of(first.path()), before) << name;
    }
    write_result_folder(first.path(), test::cam_solution(), {}, many);
    EXPECT_EQ(contents_of(first.path()), whole);
}

// A name that cannot be taken once the others have been: what a kill there would leave.
TEST(ResultFolder, ReportsIncompleteRuns) {
    const test::TemporaryFolder folder;
    write_result_folder(folder.path(), test::sample_solution());
    std::filesystem::remove(folder.path() + "/report.md");
    std::filesystem::create_directories(folder.path() + "/report.md/taken");
    EXPECT_THROW(write_result_folder(folder.path(), test::cam_solution()), InputError);
    EXPECT_NE(read_text_file(folder.path() + "/INCOMPLETE.txt").find("files of two runs"), std::string::npos);
    EXPECT_FALSE(names_in(folder.path()).contains("result.json"));  // not the one of the first run
    std::filesystem::remove_all(folder.path() + "/report.md");
    write_result_folder(folder.path(), test::cam_solution());
    EXPECT_FALSE(names_in(folder.path()).contains("INCOMPLETE.txt"));
}

TEST(ResultFolder, CleansUpAfterKilledRuns) {
    const test::TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() +
                                        "/.camopt-4194305.tmp/x");             // beyond the largest process
    std::filesystem::create_directories(folder.path() + "/.camopt-1.tmp");     // another run, not over yet
    std::filesystem::create_directories(folder.path() + "/.camopt-mine.tmp");  // not camopt's
    write_result_folder(folder.path(), test::infeasible_solution());
    EXPECT_EQ(names_in(folder.path()),
              (std::set<std::string>{".camopt-1.tmp", ".camopt-mine.tmp", "certificate.json", "report.md",
                                     "result.json", "tables.csv"}));
}

TEST(ResultFolder, RefusesAFile) {
    const test::TemporaryFolder folder;
    const std::string path = folder.path() + "/taken";
    write_text_file(path, "x");
    EXPECT_TRUE(testing_support::says(
        testing_support::refusal([&] { write_result_folder(path, test::sample_solution()); }),
        "it is a file, not a folder"));
    EXPECT_EQ(read_text_file(path), "x");
}

TEST(TextFile, ReplacesAtomicallyWithoutRemains) {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder.path() + "/file";
    write_text_file(path, "first");
    write_text_file(path, "second");
    EXPECT_EQ(read_text_file(path), "second");
    EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"file"});
    EXPECT_THROW(write_text_file(folder.path() + "/missing/file", "x"), InputError);
}

}  // namespace result_folder_test
}  // namespace camopt
