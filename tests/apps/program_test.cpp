// SPDX-License-Identifier: MIT
// The camopt program from outside: numbers, every example scene, interruptions. What it says: tests/golden.
#include "program.hpp"

#include "core/text/text_file.hpp"
#include "report/json/certificate_json.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace camopt {
namespace program_test {

using nlohmann::json;
using test::ProgramRun;
using test::run_camopt;
using test::scene;

TEST(Program, PrintsNothingButJson) {
    const ProgramRun run = run_camopt("solve " + scene("drd_cubic_12") + " --json");
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.errors, "");
    const json result = json::parse(run.output);
    EXPECT_EQ(result["verdict"], "optimal");
    EXPECT_NEAR(result["objective"].get<double>(), 0.940489277, 5e-9);  // exact: V, A, J = 12/7, 36/7, 432/7
    EXPECT_EQ(result["evaluations"]["profile_points"], 0);
}

TEST(Program, WritesTheFolderAndNothingWithoutIt) {
    const test::TemporaryFolder folder;
    const std::string out = folder.path() + "/new/results";
    const ProgramRun run = run_camopt("solve " + scene("drd_cubic_12") + " --out '" + out + "'");
    EXPECT_EQ(run.exit_code, 0);
    for (const char* name : {"result.json", "certificate.json", "motion.csv", "motion.svg", "report.md"})
        EXPECT_TRUE(std::filesystem::exists(out + "/" + name)) << name;
    const json result = json::parse(read_text_file(out + "/result.json"));
    // Anybody can recompute the bound from the file alone.
    const DualityProof proof = read_certificate(out + "/certificate.json");
    EXPECT_NEAR(recomputed_bound(proof), result["bound"]["lower"].get<double>(), 1e-12);
}

TEST(Program, SettingsReplaceKeysOfTheScene) {
    const auto segments = [](const std::string& arguments) {
        return json::parse(run_camopt(arguments + " --json").output)["spline"]["breakpoints"].size() - 1;
    };
    EXPECT_EQ(segments("solve " + scene("drd_cubic_12") + " --set spline.segments=8"), 8U);
    EXPECT_EQ(segments("solve --set spline.segments=10 objective.velocity=0.5 " + scene("drd_cubic_12")),
              10U);
}

TEST(Program, ResultHoldsThePlan) {
    const auto solved = [](const std::string& name) {
        return json::parse(run_camopt("solve " + scene(name) + " --json").output);
    };
    for (const std::string name : {"drd_cubic_12", "cam_smallest", "cam_undercut"}) {
        const json result = solved(name);
        const json &planned = result["plan"], &solver = result["solver"];
        EXPECT_EQ(planned["convex"], solver["convex"]) << name;
        EXPECT_LE(solver["starts"], planned["starts"]) << name;
        EXPECT_EQ(planned["design"], result["design"]["kind"]) << name;
        const bool settled = solver["starts"] == 0;  // by the relaxation, which has its own solver
        EXPECT_EQ(solver["name"], settled ? json("structured") : planned["solver"]) << name;
        EXPECT_EQ(planned["start_kinds"].empty(), planned["convex"].get<bool>()) << name;
        const std::string check = run_camopt("check " + scene(name)).output;
        EXPECT_NE(check.find("by " + planned["solver"].get<std::string>() + " (chosen)"), std::string::npos)
            << name;
    }
}

std::vector<std::string> scenes_of_the_project() {
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(source_folder() + "/scenes"))
        if (file.path().extension() == ".toml") names.push_back(file.path().stem());
    std::ranges::sort(names);
    return names;
}

class CheckedScene : public testing::TestWithParam<std::string> {};

TEST_P(CheckedScene, PassesWithoutFaults) {
    const ProgramRun run = run_camopt("check " + scene(GetParam()));
    EXPECT_EQ(run.exit_code, 0) << run.output << run.errors;
    EXPECT_EQ(run.output.find("derivatives are wrong"), std::string::npos) << run.output;
    for (const char* words : {"the scene is valid", "motion: ", "Solved: by ", "\nhessian "})
        EXPECT_NE(run.output.find(words), std::string::npos) << words;
}

INSTANTIATE_TEST_SUITE_P(OfTheProject, CheckedScene, testing::ValuesIn(scenes_of_the_project()),
                         [](const auto& named) { return named.param; });

TEST(Program, SaysItsVersion) {
    const std::string version = run_camopt("--version").output;
    EXPECT_TRUE(version.starts_with("camopt "));
    EXPECT_NE(version.find("MIT license. With Eigen (MPL-2.0)"), std::string::npos) << version;
    EXPECT_NE(version.find("A binary of this build"), std::string::npos) << version;
}

TEST(Program, InterruptedItDeliversWhatItHas) {
    // So many starts, and so small a gap, that it is still at work after the wait on any machine.
    const ProgramRun run = test::run_camopt_interrupted(
        "solve " + scene("cam_undercut") + " --set solver.starts=100000 --set solver.gap=1e-12 --json", 1.0);
    const json result = json::parse(run.output);
    EXPECT_EQ(result["solver"]["termination"], "interrupted");
    EXPECT_EQ(run.exit_code, result["verdict"] == "failed" ? 1 : 0) << result["verdict"];
    if (result["verdict"] == "failed") {
        EXPECT_EQ(result["reason"], "interrupted");
    }
}

TEST(Program, ReportsInterruptionBeforeFirstPoint) {
    // It searches among motions of which none is found that keeps these, until it is stopped.
    const ProgramRun run = test::run_camopt_interrupted(
        "solve " + scene("cam_undercut") +
            " --set limits.concave_radius_min_mm=500 --set limits.cam_radius_min_mm=45 "
            "--set solver.starts=100000",
        1.0);
    EXPECT_EQ(run.output.find("Failed"), std::string::npos) << run.output;
    if (run.exit_code == 1) {
        EXPECT_NE(run.output.find("Interrupted"), std::string::npos) << run.output;
    }
}

TEST(Program, InterruptedItStillWritesItsFolder) {
    const test::TemporaryFolder folder;
    // So many starts, and so small a gap, that it is still at work after the wait on any machine.
    const ProgramRun run = test::run_camopt_interrupted(
        "solve " + scene("cam_undercut") + " --set solver.starts=100000 --set solver.gap=1e-12 --out '" +
            folder.path() + "'",
        1.0);
    ASSERT_TRUE(std::filesystem::exists(folder.path() + "/result.json")) << run.output << run.errors;
    const json found = json::parse(read_text_file(folder.path() + "/result.json"));
    EXPECT_EQ(found["solver"]["termination"], "interrupted");
    EXPECT_EQ(std::filesystem::exists(folder.path() + "/profile.svg"), !found["cam"].is_null());
}

}  // namespace program_test
}  // namespace camopt
