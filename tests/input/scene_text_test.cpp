// SPDX-License-Identifier: MIT
// Scenes made by programs as scene files: the same numbers, units that people read, and what no file says.
// Scenes of every key are written in accepted_scenes_test.cpp, the examples in scene_files_test.cpp.
#include "input/scene_text.hpp"

#include "input/scene_document.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "profiles/factory/cam_formulas.hpp"
#include "scene/written_limits.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/same_scene.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

namespace camopt::input {
namespace scene_text_test {

using testing_support::says;

const KnownNames known_names = {
    .laws = {"cycloidal", "modified_sine", "run_in", "run_out", "constant_velocity"},
    .solvers = {"structured"},
    .cam_formulas = cam_formulas};

Scene scene_of(const std::string& text) {
    return read_scene(text, "text.toml", known_names);
}

/// Of a file: without a number of segments.
Scene made_scene() {
    Scene scene;
    scene.spline.by_stroke = true;
    scene.motion.lift = 20 * units::millimetre;
    scene.motion.rise = 90 * units::degree;
    scene.objective.jerk = 1.0;
    return scene;
}

TEST(SceneText, SaysWhatDiffersFromItsDefault) {
    Scene scene = made_scene();
    EXPECT_EQ(scene_text(scene),
              "[motion]\ntype = \"DRD\"\nlift_mm = 20\nrise_deg = 90\n\n[objective]\njerk = 1\n");
    scene.motion.speed = 12.0;
    scene.motion.rise = 1.25;
    scene.length_unit = LengthUnit::inch;
    scene.motion.lift = 0.75 * units::inch;
    EXPECT_EQ(scene_text(scene),
              "[motion]\ntype = \"DRD\"\nlift_in = 0.75\nrise_rad = 1.25\n"
              "speed_rad_s = 12\n\n[objective]\njerk = 1\n");
}

TEST(SceneText, KeepsNumbersOfPrograms) {
    std::mt19937_64 random(20261129);
    std::uniform_real_distribution<double> angle(0.1, 3.0), length(1e-4, 1.0);
    for (int trial = 0; trial < 300; ++trial) {
        Scene scene = made_scene();
        scene.length_unit = trial % 2 == 0 ? LengthUnit::millimetre : LengthUnit::inch;
        scene.motion.rise = angle(random);
        scene.motion.lift = length(random);
        scene.motion.speed = 100.0 * angle(random);
        scene.motion.via = {{.at = 0.5 * length(random), .displacement = length(random)}};
        scene.limits.acceleration = 5.0 + angle(random);
        const Scene again = scene_of(scene_text(scene));
        EXPECT_EQ(scene.motion, again.motion);
        EXPECT_EQ(scene.limits.acceleration->normalised, again.limits.acceleration->normalised);
    }
}

TEST(SceneText, KeepsNumbersInUnitsOfFiles) {
    std::mt19937_64 random(20261130);
    std::uniform_real_distribution<double> any(0.0, 1.0);
    for (int trial = 0; trial < 300; ++trial) {
        const Scene scene = scene_of(fmt::format(
            "[motion]\ntype = \"DRD\"\nlift_in = {}\nrise_deg = {}\nspeed_rpm = {}\n"
            "via = [{{ at_deg = {}, displacement_in = {}, velocity_in_s = {}, acceleration_mm_deg2 = {} }}]\n"
            "corridor = [{{ to_deg = {}, velocity_mm_s = {{ max = {} }} }}]\n"
            "[objective]\njerk = 1\n[limits]\nvelocity_mm_s = {}\njerk_in_deg3 = {{ max = {} }}\n",
            1.0 + any(random), 60.0 + 100.0 * any(random), 600.0 * (0.1 + any(random)), 30.0 * any(random),
            any(random), any(random), any(random), 30.0 + any(random), 1e4 * (1.0 + any(random)),
            1e4 * (1.0 + any(random)), 1.0 + any(random)));
        const std::string text = scene_text(scene);
        SCOPED_TRACE(text);
        EXPECT_EQ(testing_support::differing_parts(scene, scene_of(text)), "");
        EXPECT_TRUE(says(text, "velocity_in_s = ") && says(text, "acceleration_mm_deg2 = "));
    }
}

TEST(SceneText, WritesCamsAndLimitsOfPrograms) {
    Scene scene = made_scene();
    scene.motion.speed = 30.0;
    DiskSpec disk;
    disk[DimensionIndex::base_radius] = Dimension(0.03, 0.05);
    disk[DimensionIndex::roller_radius] = Dimension(0.01);
    scene.cam = disk_spec(disk);
    scene.limits.pressure_angle = 30.0 * units::degree;
    scene.limits.velocity = millimetres_per_second(300.0);
    const std::string text = scene_text(scene);
    EXPECT_TRUE(says(text, "base_radius_mm = {min = 30, max = 50}")) << text;
    EXPECT_TRUE(says(text, "pressure_angle_deg = 30")) << text;
    EXPECT_TRUE(says(text, "velocity_mm_s = 300")) << text;
    EXPECT_EQ(testing_support::differing_parts(with_written_limits(scene), scene_of(text)), "");
}

const char* const valve_lines =
    "[motion]\ntype = \"valve\"\nlift_mm = 10\nduration_crank_deg = 240\n"
    "checking_height_mm = 1\nlash_mm = 0.2\nrocker_ratio = 1.5\n"
    "opening_ramp = { height_mm = 0.3, velocity_mm_deg = 0.02 }\n"
    "[objective]\njerk = 1\n";

TEST(SceneText, SaysALobeByItsWords) {
    const Scene scene = scene_of(valve_lines);
    const std::string text = scene_text(scene);
    EXPECT_FALSE(says(text, "segments")) << text;
    EXPECT_TRUE(says(text, "duration_crank_deg = 240")) << text;
    EXPECT_EQ(testing_support::differing_parts(scene, scene_of(text)), "");
}

TEST(SceneText, WritesAChangedLobeAsSegments) {
    Scene scene = scene_of(valve_lines);
    scene.motion.segments[2].angle += 0.01;
    scene.motion.segments.back().angle -= 0.01;
    const Scene again = scene_of(scene_text(scene));
    EXPECT_EQ(again.motion.valve, std::nullopt);
    EXPECT_EQ(again.motion.segments, scene.motion.segments);
}

TEST(SceneText, WritesMeasuredMotionsOfPrograms) {
    Scene scene = made_scene();
    scene.measured.emplace();
    scene.measured->name = "old cam";
    for (int i = 0; i <= 10; ++i) {
        scene.measured->angle.push_back(0.1 * i * scene.motion.rise);
        scene.measured->displacement.push_back(0.01 * i * i * scene.motion.lift);
    }
    const Scene again = scene_of(scene_text(scene));
    EXPECT_EQ(again.measured, scene.measured);
}

TEST(SceneText, RefusesWhatNoFileSays) {
    const auto refused = [](const auto& change) {
        Scene scene = made_scene();
        change(scene);
        return testing_support::refusal([&] { (void)scene_text(scene); });
    };
    EXPECT_TRUE(says(refused([](Scene& s) { s.own_terms.emplace_back(); }), "own_terms: found"));
    EXPECT_TRUE(says(refused([](Scene& s) { s.spline.segments = 20; }), "spline.by_stroke: found 20"));
    EXPECT_TRUE(
        says(refused([](Scene& s) { s.limits.jerk = s.limits.jerk_min = 5.0; }), "limits.jerk: found"));
}

}  // namespace scene_text_test
}  // namespace camopt::input
