// SPDX-License-Identifier: MIT
// camopt sweep --pareto from outside: files, exit codes, words.
#include "output/report/text_file.hpp"
#include "program.hpp"
#include "tests/output/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace camopt {
namespace {

using test::ProgramRun;
using test::run_camopt;
using test::scene;

TEST(ParetoOfSweep, WritesTableAndPictures) {
    const test::TemporaryFolder folder;
    const std::string out = folder.path() + "/front";
    const ProgramRun run = run_camopt("sweep " + scene("drd_cubic_12") +
                                      " --pareto velocity,acceleration --points 7 --out '" + out + "'");
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.errors, "");
    EXPECT_NE(run.output.find("7 points of"), std::string::npos);
    for (const char* name : {"pareto.csv", "pareto.svg", "pareto.html"})
        EXPECT_TRUE(std::filesystem::exists(out + "/" + name)) << name;
    const std::string table = read_text_file(out + "/pareto.csv");
    EXPECT_EQ(std::ranges::count(table, '\n'), 1 + 7);
}

TEST(ParetoOfSweep, SaysWhatIsWrong) {
    const test::TemporaryFolder folder;
    const std::string end = " --out '" + folder.path() + "/front'";
    const std::string begin = "sweep " + scene("drd_cubic_12") + " --pareto ";
    const ProgramRun one = run_camopt(begin + "velocity" + end);
    EXPECT_EQ(one.exit_code, 2);
    EXPECT_NE(one.errors.find("allowed: two"), std::string::npos);
    EXPECT_EQ(run_camopt(begin + "velocity,speed" + end).exit_code, 2);
    EXPECT_EQ(run_camopt(begin + "velocity,jerk --weights simplex:3" + end).exit_code, 2);
    EXPECT_EQ(run_camopt(begin + "velocity,jerk --points 3 --spacing 0.1" + end).exit_code, 2);
    EXPECT_EQ(run_camopt(begin + "velocity,jerk").exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder.path() + "/front"));
}

TEST(ParetoOfSweep, AnInfeasibleSceneHasNoFront) {
    const test::TemporaryFolder folder;
    const ProgramRun run = run_camopt("sweep " + scene("infeasible_velocity_cap") +
                                      " --pareto acceleration,jerk --out '" + folder.path() + "/front'");
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_NE(run.output.find("There is no front"), std::string::npos);
}

}  // namespace
}  // namespace camopt
