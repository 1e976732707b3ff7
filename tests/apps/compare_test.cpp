// SPDX-License-Identifier: MIT
// camopt compare from outside: what goes to which stream, what is written, exit codes.
#include "core/text/text_file.hpp"
#include "program.hpp"
#include "tests/output/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>

namespace camopt {
namespace compare_test {

using nlohmann::json;
using test::ProgramRun;
using test::run_camopt;
using test::scene;

TEST(CompareCommand, PrintsJsonAndNothingElse) {
    const ProgramRun run = run_camopt("compare " + scene("drd_cubic_12") + " --json");
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.errors, "");
    const json result = json::parse(run.output);
    EXPECT_EQ(result["verdict"], "optimal");
    EXPECT_NEAR(result["objective"].get<double>(), 0.940489277, 5e-9);
    const auto row =
        std::ranges::find_if(result["rows"], [](const json& one) { return one["law"] == "modified_sine"; });
    ASSERT_NE(row, result["rows"].end());
    EXPECT_NEAR((*row)["peaks"]["velocity"]["value"].get<double>(), 1.7596, 1e-4);
    EXPECT_GT((*row)["loss_percent"].get<double>(), 6.0);
    EXPECT_TRUE(result["rows"][0]["law"].is_null());  // the optimum is the best of all
}

TEST(CompareCommand, PrintsReadableTable) {
    const ProgramRun run = run_camopt("compare " + scene("drd_cubic_12"));
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.errors, "");
    for (const char* words : {"Proved optimal", "Modified sine", "∞", "left out: turns back at its top"})
        EXPECT_NE(run.output.find(words), std::string::npos) << words;
}

TEST(CompareCommand, WritesThreeFilesOnlyWithFolder) {
    const test::TemporaryFolder folder;
    const std::string out = folder.path() + "/new";
    EXPECT_EQ(run_camopt("compare " + scene("rr_cubic_24") + " --out '" + out + "'").exit_code, 0);
    for (const char* name : {"comparison.csv", "comparison.json", "comparison.svg"})
        EXPECT_TRUE(std::filesystem::exists(out + "/" + name)) << name;
    EXPECT_TRUE(read_text_file(out + "/comparison.csv").starts_with("law,title,fits,feasible,objective,"));
}

/// The optimum's own numbers stand for the laws' free dimensions, in the objective too.
TEST(CompareCommand, UsesOptimalDimensionsOfAnyCam) {
    const ProgramRun run = run_camopt("compare " + scene("barrel_smallest") +
                                      " --set solver.starts=1 --set spline.segments=16 --json");
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    const json result = json::parse(run.output);
    const auto row_of = [&](const json& law) {
        return *std::ranges::find_if(result["rows"], [&](const json& one) { return one["law"] == law; });
    };
    const json optimum = row_of(nullptr), sine = row_of("modified_sine");
    // The scene weighs peaks over those of the modified sine, and the barrel's centre distance.
    const auto share = [&](const char* peak) {
        return optimum["peaks"][peak]["value"].get<double>() / sine["peaks"][peak]["value"].get<double>();
    };
    const double peaks = 0.4 * share("velocity") + 0.4 * share("acceleration") + 0.2 * share("jerk");
    EXPECT_EQ(optimum["objective"], result["objective"]);
    EXPECT_NEAR(sine["objective"].get<double>() - 1.0, optimum["objective"].get<double>() - peaks, 1e-9);
    EXPECT_FALSE(sine["feasible"].get<bool>());
}

TEST(CompareCommand, InfeasibleSceneStillListsLaws) {
    const ProgramRun run = run_camopt("compare " + scene("infeasible_velocity_cap") + " --json");
    EXPECT_EQ(run.exit_code, 3);
    const json result = json::parse(run.output);
    EXPECT_EQ(result["verdict"], "infeasible");
    EXPECT_TRUE(result["best_law"].is_null());
    EXPECT_GT(result["rows"].size(), 20U);
    for (const json& row : result["rows"]) {
        EXPECT_FALSE(row["feasible"]);
        EXPECT_TRUE(row["loss_percent"].is_null());
    }
}

TEST(CompareCommand, RefusesAnUnknownSolver) {
    const ProgramRun run = run_camopt("compare " + scene("drd_cubic_12") + " --solver nonsense");
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.output, "");
    EXPECT_NE(run.errors.find("nonsense"), std::string::npos);
}

}  // namespace compare_test
}  // namespace camopt
