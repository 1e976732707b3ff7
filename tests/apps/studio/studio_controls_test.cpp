// SPDX-License-Identifier: MIT
#include "apps/studio/studio_controls.hpp"

#include "apps/studio/studio_page.hpp"
#include "core/errors.hpp"
#include "input/keys/scene_keys.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace camopt::apps {
namespace studio_controls_test {

using Json = nlohmann::ordered_json;

std::string text_of(const std::string& name) {
    std::ifstream file(std::string(CAMOPT_SOURCE_DIR) + "/scenes/" + name);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

Json control_of(const Json& controls, const std::string& table, const std::string& key) {
    for (const Json& control : controls)
        if (control["table"] == table && control["key"] == key) return control;
    return nullptr;
}

TEST(StudioControls, CoverEveryNumberOfAProgram) {
    const Json controls = studio_controls(text_of("cam_drdrd.toml"));
    EXPECT_EQ(control_of(controls, "motion.segments[1]", "to_mm")["value"], 10);
    EXPECT_EQ(control_of(controls, "motion.segments[3]", "angle_deg")["value"], 70);
    EXPECT_EQ(control_of(controls, "motion.segments[1]", "kind")["choices"],
              Json({"dwell", "law", "spline"}));
    EXPECT_EQ(control_of(controls, "motion.segments[1]", "angle_deg")["slider"]["to"], 360.0);
}

TEST(StudioControls, DistinguishRangesAndPossibleRanges) {
    const Json controls = studio_controls(text_of("cam_smallest.toml"));
    const Json radius = control_of(controls, "cam", "base_radius_mm");
    EXPECT_EQ(radius["type"], "range");
    EXPECT_EQ(radius["value"]["min"], 15);
    EXPECT_TRUE(control_of(controls, "cam", "roller_radius_mm")["may_range"]);
    EXPECT_EQ(control_of(controls, "objective.reference", "jerk")["value"], 69);
}

TEST(StudioControls, OfferOnlyApplicableKeys) {
    const Json plain = studio_controls(text_of("drd_cubic_12.toml"));
    EXPECT_TRUE(control_of(plain, "limits", "pressure_angle_deg").is_null());
    EXPECT_FALSE(control_of(plain, "limits", "velocity").is_null());
    EXPECT_TRUE(control_of(plain, "spline", "breakpoints").is_null()) << "no control for a list of numbers";
    const Json cam = studio_controls(text_of("cam_roller.toml"));
    EXPECT_FALSE(control_of(cam, "limits", "concave_radius_min_mm").is_null());
    EXPECT_FALSE(control_of(cam, "limits", "concave_radius_min_mm")["given"]);
    EXPECT_TRUE(control_of(cam, "limits", "torque_nm").is_null());
}

TEST(StudioControls, CoverEveryKeyOfAScene) {
    for (const char* name : {"cam_forces.toml", "barrel_paper_cup.toml", "tappet_75.toml",
                             "inverse_feeder.toml", "drd_via_points.toml", "cylinder_slide.toml"}) {
        const Json controls = studio_controls(text_of(name));
        std::size_t given = 0;
        for (const Json& control : controls) {
            EXPECT_FALSE(control["meaning"].get<std::string>().empty());
            if (control["given"]) ++given;
        }
        EXPECT_GT(given, 4U) << name;
    }
}

TEST(StudioScene, SetsAsTheCommandLineDoes) {
    const std::string text = text_of("cam_roller.toml");
    const StudioScene set = studio_scene(text,
                                         {{"cam.base_radius_mm", {{"min", 10}, {"max", 20.5}}},
                                          {"limits.cam_radius_min_mm", nullptr},
                                          {"motion.lift_in", 0.5}},
                                         "scene");
    EXPECT_DOUBLE_EQ(set.scene.motion.lift, 0.0127);
    EXPECT_EQ(set.text.find("cam_radius_min"), std::string::npos);
    EXPECT_EQ(set.text.find("lift_mm"), std::string::npos);
    EXPECT_EQ(studio_scene(text, Json::object(), "scene").text, text) << "as given, comments and all";
}

TEST(StudioScene, RefusesInTheReadersWords) {
    const std::string text = text_of("cam_roller.toml");
    EXPECT_THROW((void)studio_scene(text, {{"cam.base_radius_mm", -1}}, "scene"), InputError);
    EXPECT_THROW((void)studio_scene(text, {{"cam.nothing", 1}}, "scene"), InputError);
    EXPECT_THROW((void)studio_scene(text, {{"spline.segments", Json::array({1})}}, "scene"), InputError);
    EXPECT_THROW((void)studio_scene("[motion", Json::object(), "scene"), InputError);
}

}  // namespace studio_controls_test
}  // namespace camopt::apps
