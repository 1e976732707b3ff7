// SPDX-License-Identifier: MIT
#include "apps/studio/studio_controls.hpp"

#include "apps/studio/studio_page.hpp"
#include "core/errors.hpp"
#include "core/units.hpp"
#include "input/keys/scene_keys.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace camopt::apps {
namespace studio_controls_test {

using Json = nlohmann::ordered_json;

std::string text_of(const std::string& name) {
    std::ifstream file(source_folder() + "/scenes/" + name);
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

TEST(StudioControls, OfferNoLiftThatMovesNothing) {
    EXPECT_TRUE(control_of(studio_controls(text_of("cam_drdrd.toml")), "motion", "lift_mm").is_null())
        << "every displacement is in mm";
    const std::string in_lifts =
        "[motion]\ntype = \"program\"\nlift_mm = 10\nsegments = [{ kind = \"spline\", "
        "angle_deg = 180, to = 1 }, { kind = \"spline\", angle_deg = 180, to = 0 }]\n";
    EXPECT_FALSE(control_of(studio_controls(in_lifts), "motion", "lift_mm").is_null());
    EXPECT_FALSE(control_of(studio_controls("[motion]\ntype = \"DRD\"\nlift_mm = 10\nvia = [{ at_deg = 50, "
                                            "displacement_mm = 4 }]\n"),
                            "motion", "lift_mm")
                     .is_null());
}

TEST(StudioControls, DistinguishRangesAndPossibleRanges) {
    const Json controls = studio_controls(text_of("cam_smallest.toml"));
    const Json radius = control_of(controls, "cam", "base_radius_mm");
    EXPECT_EQ(radius["type"], "range");
    EXPECT_EQ(radius["value"]["min"], 15);
    EXPECT_TRUE(control_of(controls, "cam", "roller_radius_mm")["may_range"]);
    EXPECT_EQ(control_of(controls, "objective.reference", "jerk")["value"], 69);
}

TEST(StudioControls, SayHowLimitsAreSought) {
    const Json controls = studio_controls(text_of("cam_roller.toml"));
    EXPECT_EQ(control_of(controls, "limits", "pressure_angle_deg")["seek"], "objective.least");
    EXPECT_EQ(control_of(controls, "limits", "cam_radius_min_mm")["seek"], "objective.largest");
    EXPECT_EQ(control_of(controls, "cam", "base_radius_mm")["seek"], "");
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

TEST(StudioControls, OfferAValveOnlyItsKeys) {
    const Json valve = studio_controls(text_of("valve_intake.toml"));
    for (const char* const key :
         {"rise_deg", "return_deg", "symmetric", "monotone", "within_lift", "closed", "repeat", "stops"})
        EXPECT_TRUE(control_of(valve, "motion", key).is_null()) << key;
    for (const char* const key : {"lift_mm", "lash_mm", "duration_crank_deg", "rocker_ratio"})
        EXPECT_FALSE(control_of(valve, "motion", key).is_null()) << key;
    const Json rise = studio_controls(text_of("drd_cubic_12.toml"));
    for (const char* const key : {"lash_mm", "duration_deg", "rocker_ratio", "closed", "repeat"})
        EXPECT_TRUE(control_of(rise, "motion", key).is_null()) << key;
    EXPECT_FALSE(control_of(rise, "motion", "symmetric").is_null());
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

TEST(StudioControls, HaveLabelsWithoutKeys) {
    const Json controls = studio_controls(text_of("cam_drdrd.toml"));
    const Json angle = control_of(controls, "motion.segments[0]", "angle_deg");
    EXPECT_EQ(angle["label"], "Segment 1: cam angle, deg");
    EXPECT_EQ(angle["group"], "Segment 1");
    const auto row = [](std::string_view table, std::string_view name) -> const KeyRow& {
        return *input::find_row(table, name);
    };
    EXPECT_EQ(control_words("limits", row("limits", "torque_max"), "N m").label,
              "Largest camshaft torque, N m");
    EXPECT_EQ(control_words("limits", row("limits", "acceleration"), "mm/s^2").label,
              "Largest acceleration, mm/s²");
    EXPECT_EQ(control_words("motion.segments[1].via[2]", row("motion.segments.via", "velocity"), "").label,
              "Set point 3 of segment 2: velocity");
    EXPECT_EQ(control_words("drawing.keyway", row("drawing.keyway", "width"), "mm").group, "Keyway");
    for (const char* name : {"cam_forces.toml", "barrel_paper_cup.toml", "inverse_feeder.toml",
                             "drd_via_points.toml", "dynamics_fast_slide.toml"})
        for (const Json& control : studio_controls(text_of(name)))
            for (const char* member : {"label", "group"}) {
                const std::string words = control[member].get<std::string>();
                EXPECT_EQ(words.find_first_of("_[."), std::string::npos) << name << ": " << words;
                EXPECT_FALSE(words.empty());
            }
}

TEST(StudioControls, TakeUnitsOfOneDimension) {
    const Json controls = studio_controls(text_of("cam_roller.toml"));
    const Json units = control_of(controls, "cam", "base_radius_mm")["units"];
    EXPECT_EQ(units, Json::parse(R"([{"unit":"mm","factor":1.0},{"unit":"in","factor":25.4},
                                     {"unit":"m","factor":1000.0}])"));
    EXPECT_EQ(control_of(controls, "objective", "velocity")["units"], Json::array());
    const std::vector<UnitChoice> by_angle =
        units_of_field(*input::find_row("motion.via", "velocity"),
                       *input::match_key("motion.via", "velocity_mm_rad").spelling);
    for (const UnitChoice& one : by_angle)
        EXPECT_EQ(one.unit.find("/s"), std::string::npos) << "by the cam angle, not in time: " << one.unit;
    EXPECT_GE(by_angle.size(), 4U);
    std::set<std::string> of_angles;
    for (const UnitChoice& one : units_of_field(*input::find_row("limits", "velocity"),
                                                *input::match_key("limits", "velocity_deg_deg").spelling))
        of_angles.insert(one.unit);
    EXPECT_EQ(of_angles, (std::set<std::string>{"deg/deg", "rad/rad"})) << "not the normalised one";
}

TEST(StudioScene, IsRewrittenInInchesAndBack) {
    const std::string text = text_of("cam_drdrd.toml");
    const StudioScene metric = studio_scene(text, Json::object(), "scene", LengthUnit::millimetre);
    EXPECT_EQ(metric.text, text) << "in these units already";
    const StudioScene inches = studio_scene(text, Json::object(), "scene", LengthUnit::inch);
    EXPECT_EQ(inches.text.find("_mm"), std::string::npos) << inches.text;
    EXPECT_EQ(inches.scene.length_unit, LengthUnit::inch);
    EXPECT_NEAR(inches.scene.motion.lift, metric.scene.motion.lift, 1e-9 * metric.scene.motion.lift);
    EXPECT_NEAR(*inches.scene.motion.segments[1].to, *metric.scene.motion.segments[1].to, 1e-9);
    const StudioScene back = studio_scene(inches.text, Json::object(), "scene", LengthUnit::millimetre);
    EXPECT_EQ(back.scene.motion.lift, metric.scene.motion.lift);
    EXPECT_EQ(back.scene.cam->middle(), metric.scene.cam->middle());
    const std::string points = text_of("handbook_nine_points.toml");
    EXPECT_NE(scene_in_units(points, LengthUnit::inch).find("acceleration_in_rad2"), std::string::npos);
    const std::string lobe = scene_in_units(text_of("valve_intake.toml"), LengthUnit::inch);
    EXPECT_NE(lobe.find("acceleration_in_deg2 = "), std::string::npos) << "not by radians: " << lobe;
    EXPECT_NE(lobe.find("jerk_in_deg3 = "), std::string::npos) << lobe;
}

TEST(StudioScene, GainsAndLosesEntriesOfLists) {
    const std::string text = text_of("cam_drdrd.toml");
    const StudioScene cut = studio_scene(
        text,
        {{"motion.segments[1].angle_deg", 30},
         {"motion.segments[2]", {{"insert", {{"kind", "dwell"}, {"angle_deg", 40}}}}},
         {"motion.segments[1].via[0]", {{"insert", {{"at_deg", 10}, {"displacement_mm", 2.5}}}}}},
        "scene");
    ASSERT_EQ(cut.scene.motion.segments.size(), 7U);
    EXPECT_EQ(cut.scene.motion.segments[2].kind, SegmentKind::dwell);
    EXPECT_DOUBLE_EQ(cut.scene.motion.segments[2].angle, 40 * units::degree);
    ASSERT_EQ(cut.scene.motion.segments[1].via.size(), 1U);
    const StudioScene less = studio_scene(cut.text,
                                          {{"motion.segments[1].via[0]", nullptr},
                                           {"motion.segments[2]", nullptr},
                                           {"motion.segments[1].angle_deg", 70}},
                                          "scene");
    EXPECT_EQ(less.scene.motion.segments.size(), 6U);
    const auto insert = [&](const char* path) {
        (void)studio_scene(text, {{path, {{"insert", {{"kind", "dwell"}, {"angle_deg", 40}}}}}}, "scene");
    };
    EXPECT_THROW(insert("motion.segments[9]"), InputError);
    EXPECT_THROW(insert("motion.segments"), InputError);
    EXPECT_THROW(insert("motion.segments[7].via[0]"), InputError);
    EXPECT_THROW(insert("title[0]"), InputError);
}

TEST(StudioDownloads, AreThoseOfTheSceneAlone) {
    const auto files = [](const char* name) {
        const std::vector<std::string> all =
            downloads_of(studio_scene(text_of(name), Json::object(), "").scene);
        return std::set<std::string>(all.begin(), all.end());
    };
    const auto motion = files("drd_cubic_12.toml"), disk = files("cam_drdrd.toml");
    EXPECT_TRUE(motion.contains("plc_codesys") && !motion.contains("nc") && !motion.contains("dxf"));
    EXPECT_TRUE(disk.contains("nc") && disk.contains("drawing_svg") && !disk.contains("second_nc"));
    EXPECT_TRUE(files("cam_conjugate.toml").contains("second_nc"));
    const auto drum = files("barrel_paper_cup.toml");
    EXPECT_TRUE(drum.contains("nc") && drum.contains("drawing_svg"));
    EXPECT_FALSE(files("inverse_feeder.toml").contains("drawing_svg"));
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
