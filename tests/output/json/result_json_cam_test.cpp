// SPDX-License-Identifier: MIT
// result.json of scenes with a cam, of programs, and of scenes that have no motion.
#include "core/text/text_file.hpp"
#include "output/json/result_json.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "tests/output/sample_solution.hpp"
#include "tests/support/middle_cam.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <string>

namespace camopt {
namespace result_json_cam_test {

using Json = nlohmann::ordered_json;

Json json_of(const Solution& solution) {
    return Json::parse(result_json(solution));
}

void expect_documented(const Json& json, const std::string& manual) {
    for (const auto& [key, value] : json.items()) {
        EXPECT_TRUE(json.is_array() || manual.find(key) != std::string::npos) << key;
        if (value.is_structured()) expect_documented(value, manual);
    }
}

TEST(ResultJson, EveryKeyIsInTheManual) {
    const std::string manual = read_text_file(source_folder() + "/docs/results.md");
    Solution cam = test::cam_solution();
    cam.cam->forward_check = ForwardCheckReport{1.2e-9, 3e-8, 0.5, 2001, 0.25};
    for (const Solution& solution : {cam, test::program_solution(), test::infeasible_cam_solution()})
        expect_documented(json_of(solution), manual);
}

TEST(ResultJsonCam, SceneWithoutCamIsReported) {
    const Json json = json_of(test::sample_solution());
    EXPECT_EQ(json["dimensions"], Json::object());
    EXPECT_TRUE(json["cam"].is_null());
    EXPECT_TRUE(json["segments"].is_null());
    EXPECT_FALSE(json.contains("conflict"));
    EXPECT_EQ(json["solver"]["convex"], true);
    EXPECT_EQ(json["solver"]["starts"], 1);
}

TEST(ResultJsonCam, ListsFollowerDimensions) {
    const Json json = json_of(test::cam_solution());
    EXPECT_EQ(json["dimensions"].dump(),
              R"({"base_radius_mm":30.0,"roller_radius_mm":10.0,"offset_mm":0.0,"prime_radius_mm":40.0})");
    Solution free = test::infeasible_cam_solution();
    free.scene.cam->set(DimensionIndex::base_radius, Dimension(0.02, 0.06));
    const Json other = json_of(free);
    EXPECT_TRUE(other["dimensions"]["base_radius_mm"].is_null());
    EXPECT_TRUE(other["dimensions"]["prime_radius_mm"].is_null());
    EXPECT_TRUE(other["cam"].is_null());
}

TEST(ResultJsonCam, UsesDisplayUnits) {
    Solution solution = test::cam_solution();
    const CamSummary& summary = solution.cam->summary;
    solution.cam->forward_check = ForwardCheckReport{1.2e-9, 3e-8, 0.5, 2001, 0.25};
    const Json cam = json_of(solution)["cam"];
    EXPECT_EQ(cam["follower"], "translating_roller");
    EXPECT_EQ(cam["rotation"], "counterclockwise");
    EXPECT_NEAR(cam["pressure_angle_deg"]["value"].get<double>(),
                summary.pressure_angle.value * 57.29577951308232, 1e-12);
    EXPECT_NEAR(cam["pressure_angle_deg"]["at_deg"].get<double>(), 90 * summary.pressure_angle.at, 1e-12);
    EXPECT_NEAR(cam["convex_radius_mm"]["value"].get<double>(), 1e3 * summary.convex_radius->value, 1e-12);
    EXPECT_EQ(cam["undercut"], false);
    EXPECT_FALSE(cam.contains("contact_offset_mm"));
    EXPECT_DOUBLE_EQ(cam["smallest"]["given_mm"].get<double>(), 40.0);
    EXPECT_NEAR(cam["forces"]["hertz_pressure_mpa"]["value"].get<double>(),
                summary.forces->hertz_pressure->value * 1e-6, 1e-9);
    EXPECT_NEAR(cam["forces"]["least_force_n"]["value"].get<double>(), summary.forces->least_force.value,
                1e-12);
    EXPECT_NEAR(cam["forward_check"]["deviation_mm"].get<double>(), 1.2e-6, 1e-18);
    EXPECT_EQ(cam["forward_check"]["points"], 2001);
    EXPECT_DOUBLE_EQ(cam["forward_check"]["at_deg"].get<double>(), 45.0);
}

TEST(ResultJsonCam, AbsentValuesAreNull) {
    Solution solution = test::cam_solution();
    solution.scene.limits.pressure_angle.reset();
    solution.cam->smallest.reset();
    solution.cam->summary.forces.reset();
    solution.cam->summary.concave_radius.reset();
    solution.cam->summary.convex_radius->value = 1e300;
    ConstraintReport concave;
    concave.key = "limits.concave_radius_min_mm";
    concave.worst = std::numeric_limits<double>::infinity();
    solution.constraints.push_back(concave);
    const std::string text = result_json(solution);
    const Json json = Json::parse(text);
    for (const char* key : {"convex_radius_mm", "concave_radius_mm", "smallest", "forces", "forward_check"})
        EXPECT_TRUE(json["cam"][key].is_null()) << key;
    EXPECT_TRUE(json["constraints"].back()["worst"].is_null());
}

TEST(ResultJsonCam, ReportsContactOffsetAndMoment) {
    Solution solution = test::cam_solution();
    solution.scene.cam = disk_spec({.follower = FollowerType::oscillating_flat});
    solution.scene.cam->set(DimensionIndex::base_radius, 30 * units::millimetre);
    solution.cam->cam = disk_mechanism(middle_cam(disk_of(*solution.scene.cam)));
    solution.cam->summary.contact_offset = CamExtreme{2e-3, 0.5};
    solution.scene.motion.lift_is_angle = true;
    solution.cam->forward_check = ForwardCheckReport{1e-9, 1e-8, 0.5, 2001, 0.25};
    const Json json = json_of(solution);
    EXPECT_TRUE(json["cam"].contains("contact_offset_mm"));
    EXPECT_TRUE(json["cam"]["forces"].contains("least_moment_nm"));
    EXPECT_TRUE(json["cam"]["forward_check"].contains("deviation_deg"));
    EXPECT_EQ(
        json["dimensions"].dump(),
        R"({"base_radius_mm":30.0,"center_distance_mm":0.0,"face_offset_mm":0.0,"prime_radius_mm":30.0})");
}

TEST(ResultJsonCam, UndercutIsReported) {
    const Json cam = json_of(test::undercut_solution())["cam"];
    EXPECT_EQ(cam["undercut"], true);
    EXPECT_LE(cam["regularity"]["value"].get<double>(), 0.0);
}

TEST(ResultJsonProgram, ListsSegmentsInsteadOfSpline) {
    const Json json = json_of(test::program_solution());
    EXPECT_TRUE(json["spline"].is_null());
    ASSERT_EQ(json["segments"].size(), 4U);
    const Json& rise = json["segments"][1];
    EXPECT_EQ(rise["kind"], "spline");
    EXPECT_NEAR(rise["start_deg"].get<double>(), 60.0, 1e-12);
    EXPECT_NEAR(rise["angle_deg"].get<double>(), 90.0, 1e-12);
    EXPECT_EQ(rise["to"], 1.0);
    EXPECT_EQ(rise["continuity"], 2);
    EXPECT_EQ(rise["peaks"]["velocity"]["value"], 2.0);
    EXPECT_EQ(rise["spline"]["degree"], 3);
    EXPECT_TRUE(rise["law"].is_null());
    const Json& back = json["segments"][3];
    EXPECT_EQ(back["law"], "modified_sine");
    EXPECT_NEAR(back["peaks"]["acceleration"]["value"].get<double>(), 5.527957070544091, 1e-12);
    EXPECT_NEAR(back["peaks"]["velocity"]["at"].get<double>(), 3.75, 1e-12);
    EXPECT_TRUE(back["spline"].is_null());
    EXPECT_TRUE(json["segments"][0]["peaks"].is_null());
}

TEST(ResultJsonProgram, PhysicalPeaksMatchMotion) {
    const Json json = json_of(test::program_solution());
    EXPECT_EQ(json["peaks"]["velocity"]["value"], 2.0);
    EXPECT_NEAR(json["physical_peaks"]["v_mm_s"].get<double>(), 3.5192 * 10.0 / 0.05, 1e-9);
}

TEST(ResultJsonProgram, OpenStartHasNoContinuity) {
    Solution solution = test::program_solution();
    solution.segments[0].continuity = -1;
    EXPECT_TRUE(json_of(solution)["segments"][0]["continuity"].is_null());
}

TEST(ResultJsonInfeasible, NamesConflictingLimits) {
    const Json json = json_of(test::infeasible_cam_solution());
    ASSERT_EQ(json["conflict"].size(), 4U);
    EXPECT_EQ(json["conflict"][0]["key"], "limits.pressure_angle_deg");
    EXPECT_NEAR(json["conflict"][0]["at_deg"].get<double>(), 23.4, 1e-12);
    EXPECT_EQ(json["conflict"][0]["weight"], 0.4);
    EXPECT_EQ(json["relaxation"][0]["key"], "cam.base_radius_mm");
}

}  // namespace result_json_cam_test
}  // namespace camopt
