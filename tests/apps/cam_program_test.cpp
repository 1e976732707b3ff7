// SPDX-License-Identifier: MIT
// The camopt program on scenes with cams and programs: what is printed, what is written.
#include "core/text/text_file.hpp"
#include "program.hpp"
#include "tests/output/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>

namespace camopt {
namespace cam_program_test {

using nlohmann::json;
using test::ProgramRun;
using test::run_camopt;

/// A translating roller on a rise of 60 deg: convex, solved in a moment.
const char* const cam_scene = R"(
title = "A cam"
[motion]
type = "DRD"
lift_mm = 20
rise_deg = 60
[spline]
segments = 12
[objective]
acceleration = 1
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = 30
roller_radius_mm = 10
[limits]
pressure_angle_deg = 31
)";

const char* const program_scene = R"(
[motion]
type = "program"
lift_mm = 10
[[motion.segments]]
kind = "dwell"
angle_deg = 150
[[motion.segments]]
kind = "spline"
angle_deg = 90
to = 1.0
[[motion.segments]]
kind = "law"
law = "cycloidal"
angle_deg = 120
to = 0.0
[spline]
segments = 8
[objective]
acceleration = 1
[cam]
type = "disk"
follower = "translating_flat"
base_radius_mm = 40
)";

class CamProgram : public ::testing::Test {
 protected:
    /// A scene file, quoted for the shell.
    [[nodiscard]] std::string file(const std::string& text) const {
        const std::string path = folder_.path() + "/scene.toml";
        write_text_file(path, text);
        return "'" + path + "'";
    }
    [[nodiscard]] std::string out() const { return folder_.path() + "/results"; }
    [[nodiscard]] bool wrote(const std::string& name) const {
        return std::filesystem::exists(out() + "/" + name);
    }
    [[nodiscard]] json result() const { return json::parse(read_text_file(out() + "/result.json")); }

 private:
    test::TemporaryFolder folder_;
};

TEST_F(CamProgram, WritesTheProfileAndChecksIt) {
    const ProgramRun run =
        run_camopt("solve " + file(cam_scene) + " --out '" + out() + "' --dxf --points 90");
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    for (const char* name :
         {"motion.csv", "profile.csv", "profile.svg", "profile_diagrams.svg", "profile.dxf", "report.md"})
        EXPECT_TRUE(wrote(name)) << name;
    const std::string table = read_text_file(out() + "/profile.csv");
    EXPECT_NEAR(static_cast<double>(std::count(table.begin(), table.end(), '\n')), 98.0, 8.0);
    const json cam = result()["cam"];
    EXPECT_LT(cam["forward_check"]["relative"].get<double>(), 1e-6);
    EXPECT_NEAR(cam["pressure_angle_deg"]["value"].get<double>(), 31.0, 1e-6);
    EXPECT_NE(run.output.find("Forward check by points alone: "), std::string::npos);
    EXPECT_NE(run.output.find("Active limits: the pressure angle at "), std::string::npos);
}

TEST_F(CamProgram, LaterRunRemovesDrawing) {
    const std::string solve = "solve " + file(cam_scene) + " --out '" + out() + "'";
    EXPECT_EQ(run_camopt(solve + " --dxf").exit_code, 0);
    EXPECT_TRUE(wrote("profile.dxf"));
    EXPECT_EQ(run_camopt(solve).exit_code, 0);
    EXPECT_FALSE(wrote("profile.dxf"));
    EXPECT_TRUE(wrote("profile.svg"));
    EXPECT_EQ(run_camopt(solve + " --set limits.pressure_angle_deg=15").exit_code, 3);
    EXPECT_FALSE(wrote("profile.svg"));
}

TEST_F(CamProgram, WithoutAFolderNothingIsChecked) {
    const ProgramRun run = run_camopt("solve " + file(cam_scene) + " --json");
    EXPECT_EQ(run.errors, "");
    const json found = json::parse(run.output);
    EXPECT_TRUE(found["cam"]["forward_check"].is_null());
    EXPECT_EQ(found["dimensions"]["prime_radius_mm"], 40.0);
    EXPECT_GT(found["evaluations"]["profile_points"].get<long>(), 0);
}

TEST_F(CamProgram, AnInfeasibleCamIsExplained) {
    const ProgramRun run = run_camopt("solve " + file(cam_scene) + " --set limits.pressure_angle_deg=15");
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_NE(run.output.find("The pressure angle limit "), std::string::npos) << run.output;
    EXPECT_NE(run.output.find("Any one of these changes suffices: "), std::string::npos) << run.output;
    EXPECT_NE(run.output.find("increase the base radius to "), std::string::npos) << run.output;
}

TEST_F(CamProgram, ProgramIsOneRevolution) {
    const ProgramRun run = run_camopt("solve " + file(program_scene) + " --out '" + out() + "'");
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    const json found = result();
    EXPECT_TRUE(found["spline"].is_null());
    ASSERT_EQ(found["segments"].size(), 3U);
    EXPECT_EQ(found["segments"][2]["law"], "cycloidal");
    EXPECT_NEAR(found["segments"][1]["peaks"]["acceleration"]["value"].get<double>(),
                found["peaks"]["acceleration"]["value"].get<double>(), 1e-12);
    EXPECT_TRUE(found["cam"].contains("contact_offset_mm"));
    EXPECT_LT(found["cam"]["forward_check"]["relative"].get<double>(), 1e-6);
    EXPECT_NE(run.output.find("cycloidal"), std::string::npos);
}

TEST_F(CamProgram, AnInverseCamHasItsGuide) {
    const std::string solve =
        "solve " + test::scene("inverse_feeder") + " --set solver.starts=1 --points 500";
    const ProgramRun run = run_camopt(solve + " --out '" + out() + "'");
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    for (const char* file : {"guide.csv", "guide.svg", "pressure_angle.svg", "report.md"})
        EXPECT_TRUE(wrote(file)) << file;
    EXPECT_FALSE(wrote("profile.csv"));
    EXPECT_FALSE(wrote("profile.dxf"));
    const json check = result()["cam"]["forward_check"];
    ASSERT_FALSE(check.is_null());
    EXPECT_LT(check["relative"].get<double>(), 1e-8);
    EXPECT_NE(run.output.find("points of the guide's walls"), std::string::npos) << run.output;
}

TEST_F(CamProgram, ADrumHasNoDrawing) {
    const ProgramRun run =
        run_camopt("solve " + test::scene("barrel_paper_cup") + " --dxf --out '" + out() + "'");
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.errors.find("allowed: with types \"disk\", \"remote\" and \"inverse\""), std::string::npos)
        << run.errors;
    EXPECT_FALSE(wrote("result.json"));
}

TEST_F(CamProgram, CheckSaysWhichLimitsAreLinear) {
    const ProgramRun run = run_camopt("check " + file(cam_scene) + " --set limits.cam_radius_min_mm=1");
    EXPECT_EQ(run.exit_code, 0) << run.output << run.errors;
    EXPECT_NE(run.output.find("limit: limits.pressure_angle_deg is linear"), std::string::npos) << run.output;
    EXPECT_NE(run.output.find("limit: limits.cam_radius_min_mm is general"), std::string::npos) << run.output;
}

TEST_F(CamProgram, InterruptedItStillWritesItsFolder) {
    // So many starts, and so small a gap, that it is still at work after the wait on any machine.
    const ProgramRun run = test::run_camopt_interrupted(
        "solve " + test::scene("cam_undercut") +
            " --set solver.starts=100000 --set solver.gap=1e-12 --out '" + out() + "'",
        1.0);
    ASSERT_TRUE(wrote("result.json")) << run.output << run.errors;
    const json found = result();
    EXPECT_EQ(found["solver"]["termination"], "interrupted");
    EXPECT_EQ(wrote("profile.svg"), !found["cam"].is_null());
}

TEST_F(CamProgram, OptionsOfFilesNeedAFolder) {
    for (const char* option : {" --dxf", " --points 90", " --out x --points 3"}) {
        const ProgramRun run = run_camopt("solve " + file(cam_scene) + option);
        EXPECT_EQ(run.exit_code, 2) << option;
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    }
}

}  // namespace cam_program_test
}  // namespace camopt
