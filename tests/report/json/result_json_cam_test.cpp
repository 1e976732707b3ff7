// SPDX-License-Identifier: MIT
// result.json of scenes with a cam, of programs, and of scenes that have no motion.
#include "core/text/text_file.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "report/json/result_json.hpp"
#include "tests/report/sample_solution.hpp"
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

TEST(ResultJson, InvalidByteInTitleIsEscaped) {
    Solution solution = test::sample_solution();
    solution.scene.title = "broken \xff title";
    EXPECT_TRUE(Json::accept(result_json(solution)));
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

TEST(ResultJsonProgram, OpenStartHasNoContinuity) {
    Solution solution = test::program_solution();
    solution.segments[0].continuity = -1;
    EXPECT_TRUE(json_of(solution)["segments"][0]["continuity"].is_null());
}

}  // namespace result_json_cam_test
}  // namespace camopt
