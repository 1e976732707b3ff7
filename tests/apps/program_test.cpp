// SPDX-License-Identifier: MIT
// The camopt program from outside: exit codes, what goes to which stream, what is written.
#include "program.hpp"

#include "core/text/text_file.hpp"
#include "output/json/certificate_reader.hpp"
#include "tests/output/temporary_folder.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace camopt {
namespace program_test {

using nlohmann::json;
using test::ProgramRun;
using test::run_camopt;
using test::scene;

/// Exit 2, nothing on stdout, one line "camopt: …" with these words on stderr.
void expect_refused(const std::string& arguments, const std::string& words) {
    const ProgramRun run = run_camopt(arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_EQ(run.output, "") << arguments;
    EXPECT_TRUE(run.errors.starts_with("camopt: ")) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_NE(run.errors.find(words), std::string::npos) << run.errors;
}

TEST(Program, PrintsNothingButJson) {
    const ProgramRun run = run_camopt("solve " + scene("drd_cubic_12") + " --json");
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.errors, "");
    const json result = json::parse(run.output);
    EXPECT_EQ(result["verdict"], "optimal");
    EXPECT_NEAR(result["objective"].get<double>(), 0.940489277, 5e-9);  // exact: V, A, J = 12/7, 36/7, 432/7
    EXPECT_EQ(result["evaluations"]["profile_points"], 0);
}

TEST(Program, LateSceneFailureIsInvalidInput) {
    expect_refused("solve /", "found a directory");
    if (std::filesystem::exists("/proc/self/mem")) {
        expect_refused("solve /proc/self/mem", "cannot be read");
        expect_refused("check /proc/self/mem", "cannot be read");
        expect_refused("sweep /proc/self/mem --vary spline.segments=4:6:2 --out unused", "cannot read");
    }
}

TEST(Program, PrintsReadableSummary) {
    const ProgramRun run = run_camopt("solve " + scene("drd_cubic_12"));
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.errors, "");
    EXPECT_NE(run.output.find("Proved optimal"), std::string::npos);
    EXPECT_NE(run.output.find("V = 1.71429"), std::string::npos);
    EXPECT_NE(run.output.find("−2.6 %"), std::string::npos);
}

TEST(Program, PrintsAndWritesThePublishedTable) {
    const test::TemporaryFolder folder;
    const std::string out = folder.path() + "/table";
    const ProgramRun run = run_camopt("table spline-vs-modified-sine --json --out '" + out + "'");
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.errors, "");
    EXPECT_TRUE(json::parse(run.output)["all_optimal"].get<bool>());
    std::set<std::string> names = {"table.json", "report.md"};
    for (const char* number : {"1", "2", "3", "4"}) names.insert(std::string("table_") + number + ".csv");
    for (const char* number : {"1", "2", "3", "4", "5", "6", "7", "8"})
        for (const char* type : {".csv", ".svg"}) names.insert(std::string("figure_") + number + type);
    std::set<std::string> written;
    for (const auto& entry : std::filesystem::directory_iterator(out))
        written.insert(entry.path().filename().string());
    EXPECT_EQ(written, names);
    EXPECT_EQ(read_text_file(out + "/table.json"), run.output);
    expect_refused("table no-such-table", "no-such-table");
    expect_refused("table", "WHAT");
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

TEST(Program, InfeasibleExitCodeIsThree) {
    const ProgramRun run = run_camopt("solve " + scene("infeasible_velocity_cap") + " --json");
    EXPECT_EQ(run.exit_code, 3);
    const json result = json::parse(run.output);
    EXPECT_EQ(result["verdict"], "infeasible");
    EXPECT_TRUE(result["spline"].is_null());
    EXPECT_EQ(result["relaxation"][0]["key"], "limits.velocity");
    EXPECT_GT(result["relaxation"][0]["needed"].get<double>(),
              result["relaxation"][0]["given"].get<double>());
}

TEST(Program, SettingsReplaceKeysOfTheScene) {
    const auto segments = [](const std::string& arguments) {
        return json::parse(run_camopt(arguments + " --json").output)["spline"]["breakpoints"].size() - 1;
    };
    EXPECT_EQ(segments("solve " + scene("drd_cubic_12") + " --set spline.segments=8"), 8U);
    EXPECT_EQ(segments("solve --set spline.segments=10 objective.velocity=0.5 " + scene("drd_cubic_12")),
              10U);
    expect_refused("solve " + scene("drd_cubic_12") + " --set spline.segmets=8", "--set spline.segmets=8");
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

TEST(Program, ASolverIsChosenByName) {
    const json result =
        json::parse(run_camopt("solve " + scene("drd_cubic_12") + " --solver structured --json").output);
    EXPECT_EQ(result["solver"]["name"], "structured");
    EXPECT_TRUE(result["solver"]["choice"].is_null());
    expect_refused("solve " + scene("drd_cubic_12") + " --solver simplex", "\"structured\"");
}

TEST(Program, RefusesAWrongCommandLine) {
    expect_refused("", "subcommand");
    expect_refused("frobnicate", "--help");
    expect_refused("solve", "the scene file is missing");
    expect_refused("solve " + scene("drd_cubic_12") + " --frob", "--frob");
    expect_refused("solve /nowhere/scene.toml", "/nowhere/scene.toml");
    expect_refused("list gears", "laws");
    expect_refused("list", "WHAT");
    expect_refused("solve " + scene("drd_cubic_12") + " --out " + scene("drd_cubic_12"),
                   "it is a file, not a folder");
}

TEST(Program, UnknownOptionsAndCommandsGetAHint) {
    const std::string plain = scene("drd_cubic_12");
    expect_refused("solve " + plain + " --out x --point 20",
                   "'--point' of camopt solve; did you mean '--points'?");
    expect_refused("solve " + plain + " --ot=x", "'--ot' of camopt solve; did you mean '--out'?");
    expect_refused("sweep " + plain + " --resumme", "'--resumme' of camopt sweep; did you mean '--resume'?");
    expect_refused("sweep merge a b --oot x", "'--oot' of camopt sweep merge; did you mean '--out'?");
    expect_refused("sovle " + plain, "unknown command 'sovle'; allowed: solve, ");
    expect_refused("sovle " + plain, "; did you mean 'solve'?");
    expect_refused("--verson", "'--verson' of camopt; did you mean '--version'?");
    expect_refused("list follower",
                   "found 'follower'; allowed: laws, followers, solvers, keys, columns, controllers; did you "
                   "mean 'followers'?");
    expect_refused("solve " + plain + " --frobnicate", "unknown option '--frobnicate' of camopt solve (see");
}

TEST(Program, RefusesIgnoredSettingsBeforeSolving) {
    const test::TemporaryFolder folder;
    const std::string out = folder.path() + "/out";
    const std::string plain = scene("drd_cubic_12");
    expect_refused("solve " + plain + " --out '" + out + "' --dxf", "--dxf: found in a scene without a cam");
    expect_refused("solve " + plain + " --out '" + out + "' --points 100",
                   "--points: found in a scene without a cam");
    EXPECT_FALSE(std::filesystem::exists(out));
    for (const char* command : {"solve", "compare", "export", "sweep --weights simplex:2"})
        expect_refused(command + (" " + scene("cam_roller")) + " --out ''", "--out: found an empty text");
    expect_refused("solve " + plain + " --solver ''", "--solver: found an empty text");
    expect_refused("table spline-vs-modified-sine --out ''", "--out: found an empty text");
}

TEST(Program, RefusesAnIncompleteCamOrProgram) {
    const test::TemporaryFolder folder;
    const std::string path = folder.path() + "/scene.toml";
    const std::string rest = "[spline]\nsegments = 8\n[objective]\nvelocity = 1\n";
    write_text_file(path, "[motion]\ntype = \"DRD\"\n" + rest + "[cam]\ntype = \"disk\"\n");
    expect_refused("solve '" + path + "'", "cam");
    write_text_file(path, "[motion]\ntype = \"program\"\n" + rest);
    expect_refused("solve '" + path + "'", "program");
}

// What no reader can see (it needs the formulas of a cam, the spline, a law) names its place all the same.
TEST(Program, RefusalsNameFileAndLine) {
    const test::TemporaryFolder folder;
    const std::string path = folder.path() + "/scene.toml";
    const std::string motion = "[motion]\ntype = \"DRD\"\nspeed_rpm = 60\n";
    write_text_file(path, motion + "[objective]\njerk = 1\n");
    expect_refused(
        "dynamics '" + path + "'",
        path + ":1:1: dynamics: found a scene without a [dynamics] table; allowed: a scene with one");
    write_text_file(path, motion + "[objective]\njerk = 1\n[spline]\nsegments = 24\n[measured]\n" +
                              "theta_deg = [0, 20, 50, 80, 100, 130, 160, 180]\n" +
                              "s_mm = [0, 0, 0.1, 0.4, 0.6, 0.9, 1, 1]\n");
    expect_refused("solve '" + path + "'", path + ":8:1: measured: found 8 rows for a spline with ");
    expect_refused("check " + scene("inverse_feeder") + " --set motion.lift_mm=5000",
                   "inverse_feeder.toml:23:1: cam: found the feeder's linkage does not reach");
    write_text_file(path, motion + "[objective]\njerk = 1\nreference = \"parabolic\"\n");
    expect_refused("solve '" + path + "'",
                   path + ":6:13: objective.reference: found \"parabolic\", which has no finite jerk");
    expect_refused("solve '" + path + "' --set objective.reference=simple_harmonic",
                   "--set objective.reference=simple_harmonic: objective.reference: found ");
}

TEST(Program, CheckNeedsNoSolve) {
    const ProgramRun run = run_camopt("check " + scene("drd_cubic_12"));
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NE(run.output.find("the scene is valid"), std::string::npos);
    EXPECT_NE(run.output.find("jacobian  agrees with differences"), std::string::npos);
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
    EXPECT_EQ(run.output.find("wrong"), std::string::npos) << run.output;
    for (const char* words : {"the scene is valid", "Motion: ", "Objective: ", "Solved: by ",
                              "hessian   agrees with differences"})
        EXPECT_NE(run.output.find(words), std::string::npos) << words;
    const bool prescribed = run.output.find("a prescribed motion") != std::string::npos;
    EXPECT_NE(run.output.find("Spline: ") != std::string::npos, prescribed) << run.output;
}

INSTANTIATE_TEST_SUITE_P(OfTheProject, CheckedScene, testing::ValuesIn(scenes_of_the_project()),
                         [](const auto& named) { return named.param; });

TEST(Program, CheckSaysWhatTheSceneIs) {
    const auto checked = [](const std::string& arguments) {
        std::string text = run_camopt("check " + arguments).output;
        for (std::size_t at = 0; (at = text.find("\n  ", at)) != std::string::npos;) text.replace(at, 3, " ");
        return text;
    };
    const auto expect_words = [](const std::string& text, std::initializer_list<const char*> all) {
        for (const char* words : all) EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    };
    expect_words(checked(scene("cam_smallest")),
                 {"translating roller", "base radius free from", "prime radius free from",
                  "Limits: ", "pressure angle <= "});
    expect_words(checked(scene("barrel_smallest")), {"barrel cam", "Limits: ", "not convex",
                                                     "a convex relaxation first", "dimension of the cam"});
    expect_words(checked(scene("cam_drdrd")),
                 {"a program of", "Segments: ", "spline 100 deg to 0 mm (0 of the lift)"});
    expect_words(checked(scene("cam_forces")), {"Forces: mass ", "contact force"});
    expect_words(checked(scene("drd_free_knots")), {"its breakpoints free", "6 breakpoints", "moves them"});
    expect_words(
        checked(scene("drd_cubic_12") +
                " --set motion.speed_rpm=300 --set limits.velocity=1.8 "
                "--set motion.lift_mm=10 --set motion.rise_deg=120 --set solver.max_seconds=5"),
        {"Motion: rise between two dwells, lift 10 mm, rise 120 deg, at 300 rpm",
         "Spline: degree 3, 12 uniform segments", "Limits: velocity <= 1.8 (normalised)",
         "0.4 × velocity + 0.4 × acceleration + 0.2 × jerk", "velocity 1.76, acceleration 5.53, jerk 69",
         "Searched: the motion Solved: by structured (chosen), design vector: states, at most 5 s",
         "Ties: of equal optima the smoothest motion",
         "Expected verdict: optimal or infeasible, both with a proof"});
}

TEST(Program, CheckAndSolveNameTheSameSolver) {
    const auto expect_same = [](const std::string& arguments, const std::string& checked,
                                const std::string& solved) {
        const std::string check = run_camopt("check " + arguments).output;
        EXPECT_NE(check.find(checked), std::string::npos) << check;
        const std::string solve = run_camopt("solve " + arguments).output;
        EXPECT_NE(solve.find("\n  solver: " + solved), std::string::npos) << solve;
    };
    const std::string prescribed = source_folder() + "/tests/cases/55_mill.toml";
    expect_same(prescribed, "\n  Solved: by no solver, the motion is prescribed\n",
                "none, the motion is prescribed, ");
    const std::string unused = "the motion is prescribed; structured is not used";
    expect_same(prescribed + " --set 'solver.name=\"structured\"'", "\n  Solved: by no solver, " + unused,
                "none, " + unused);
    expect_same(scene("cam_arm_roller"),
                "\n  Solved: by structured where the convex relaxation decides, else by ", "structured");
    expect_same(scene("drd_cubic_12"), "\n  Solved: by structured (chosen)", "structured, iterations ");
}

TEST(Program, ListsWhatItKnows) {
    const json laws = json::parse(run_camopt("list laws --json").output);
    const auto sine =
        std::find_if(laws.begin(), laws.end(), [](const json& law) { return law["key"] == "modified_sine"; });
    ASSERT_NE(sine, laws.end());
    EXPECT_NEAR((*sine)["acceleration"].get<double>(), 5.527957070544091, 1e-12);
    EXPECT_EQ(json::parse(run_camopt("list solvers --json").output)[0]["name"], "structured");
}

TEST(Program, ListsTheFollowersWithTheirDimensions) {
    const json followers = json::parse(run_camopt("list followers --json").output);
    ASSERT_EQ(followers.size(), 13U);  // 5 on disks, 4 linkages, 3 on drums, 1 inverse
    EXPECT_EQ(followers[3]["key"], "oscillating_roller");
    EXPECT_EQ(followers[3]["lift"], "lift_deg");
    EXPECT_EQ(followers[3]["dimensions"],
              (json{"base_radius_mm", "roller_radius_mm", "center_distance_mm", "arm_length_mm",
                    "groove_clearance_mm", "groove_wall_mm", "second_roller_radius_mm", "arm_angle_deg",
                    "second_arm_length_mm"}));
    EXPECT_NE(run_camopt("list followers").output.find("translating_flat     lift_mm   a flat face"),
              std::string::npos);
}

TEST(Program, ListsFollowersOfEveryKind) {
    const json followers = json::parse(run_camopt("list followers --json").output);
    const auto keys_of = [&](const char* cam, const char* key) {
        for (const json& row : followers)
            if (row["cam"] == cam && row["key"] == key) return row["dimensions"].dump();
        return std::string("not listed");
    };
    EXPECT_NE(keys_of("remote", "lever_coupler_slider").find("\"linkage.coupler_mm\""), std::string::npos);
    EXPECT_NE(keys_of("barrel", "barrel").find("\"lateral_offset_mm\""), std::string::npos);
    EXPECT_NE(keys_of("cylindrical", "translating").find("\"cylinder_radius_mm\""), std::string::npos);
    EXPECT_NE(keys_of("cylindrical", "rotating").find("\"start_angle_deg\""), std::string::npos);
    EXPECT_NE(keys_of("inverse", "inverse").find("\"feeder_offset_mm\""), std::string::npos);
    const std::string text = run_camopt("list followers").output;
    for (const char* words : {"cam.type = \"remote\", linkage.type =", "cam.type = \"barrel\"",
                              "cam.type = \"cylindrical\", cam.follower =", "cam.type = \"inverse\""})
        EXPECT_NE(text.find(words), std::string::npos) << words;
}

TEST(Program, SaysItsVersionAndHelps) {
    const std::string version = run_camopt("--version").output;
    EXPECT_TRUE(version.starts_with("camopt "));
    EXPECT_NE(version.find("MIT license. With Eigen (MPL-2.0)"), std::string::npos) << version;
    EXPECT_NE(version.find("A binary of this build"), std::string::npos) << version;
    const ProgramRun help = run_camopt("--help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.output.find("Examples:"), std::string::npos);
    EXPECT_NE(help.output.find("Exit codes: 0"), std::string::npos);
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

}  // namespace program_test
}  // namespace camopt
