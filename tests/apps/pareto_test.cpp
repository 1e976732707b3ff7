// SPDX-License-Identifier: MIT
// camopt sweep --pareto and --surface from outside: files, exit codes, words.
#include "core/text/text_file.hpp"
#include "program.hpp"
#include "tests/output/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace camopt {
namespace pareto_test {

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

TEST(SurfaceOfSweep, WritesReadsAndResumes) {
    const test::TemporaryFolder folder;
    const std::string out = folder.path() + "/surface";
    const std::string begin = "sweep " + scene("drd_cubic_12") + " --surface ";
    const ProgramRun part = run_camopt(begin + "1e-2 --most 5 --out '" + out + "'");
    EXPECT_EQ(part.exit_code, 0) << part.errors;
    EXPECT_NE(part.output.find("5 solves"), std::string::npos) << part.output;
    EXPECT_NE(part.output.find("--most ended it"), std::string::npos) << part.output;
    const ProgramRun run = run_camopt(begin + "1e-2 --resume --out '" + out + "'");
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(run.output.find("ended it"), std::string::npos) << run.output;
    for (const char* name : {"surface.csv", "surface.svg", "surface.html", "surface.obj", "surface.json"})
        EXPECT_TRUE(std::filesystem::exists(out + "/" + name)) << name;
    const ProgramRun looked_up = run_camopt("sweep '" + out + "' --at 4,4,2");
    EXPECT_EQ(looked_up.exit_code, 0) << looked_up.errors;
    EXPECT_NE(looked_up.output.find("lies between 0.9"), std::string::npos) << looked_up.output;
}

TEST(SurfaceOfSweep, SaysWhatIsWrong) {
    const test::TemporaryFolder folder;
    const std::string out = " --out '" + folder.path() + "/surface'";
    const auto fault = [](const std::string& words) {
        const ProgramRun run = run_camopt(words);
        EXPECT_EQ(run.exit_code, 2) << words;
        return run.errors;
    };
    const std::string begin = "sweep " + scene("drd_cubic_12");
    EXPECT_NE(fault(begin + " --surface 0" + out).find("between 0 and 1"), std::string::npos);
    EXPECT_NE(fault(begin + " --surface 1e-2").find("--out is missing"), std::string::npos);
    EXPECT_NE(fault(begin + " --surface 1e-2 --weights simplex:3" + out).find("--weights"),
              std::string::npos);
    EXPECT_NE(fault("sweep " + scene("drd_torque") + " --surface 1e-2" + out).find("objective.torque"),
              std::string::npos);
    EXPECT_NE(fault("sweep '" + folder.path() + "' --at 1,1,1").find("surface.json"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder.path() + "/surface"));
    EXPECT_EQ(run_camopt(begin + " --surface 0.5" + out).exit_code, 0);
    const std::string look_up = "sweep '" + folder.path() + "/surface' --at ";
    EXPECT_NE(fault(look_up + "1,1").find("three numbers"), std::string::npos);
    EXPECT_NE(fault(look_up + "1,1,1,1").find("three numbers"), std::string::npos);
    EXPECT_NE(fault(look_up + "0,0,0").find("positive sum"), std::string::npos);
    EXPECT_NE(fault("sweep " + scene("drd_cubic_16") + " --surface 0.5 --resume" + out).find("another scene"),
              std::string::npos);
}

TEST(ParetoOfSweep, InfeasibleSceneHasNoFront) {
    const test::TemporaryFolder folder;
    const ProgramRun run = run_camopt("sweep " + scene("infeasible_velocity_cap") +
                                      " --pareto acceleration,jerk --out '" + folder.path() + "/front'");
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_NE(run.output.find("There is no front"), std::string::npos);
}

}  // namespace pareto_test
}  // namespace camopt
