// SPDX-License-Identifier: MIT
// Scenes made key by key: the words of scene files, and nothing changed by what is refused.
#include "input/scene_document.hpp"

#include "profiles/factory/cam_formulas.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace camopt::input {
namespace scene_document_test {

using testing_support::says;

const KnownNames document_names = {
    .laws = {"cycloidal", "modified_sine"}, .solvers = {"structured"}, .cam_formulas = cam_formulas};
const std::string document_scene =
    "# a comment\n[motion]\ntype = \"DRD\"\nlift_in = 1\n[objective]\njerk = 1\n";

SceneDocument document_of(const std::string& toml) {
    return {toml, "s.toml", document_names};
}

/// What was thrown; the text of the document is that before.
std::string refused(SceneDocument& document, const std::function<void()>& change) {
    const std::string before = document.text();
    std::string words = testing_support::refusal(change);
    EXPECT_EQ(document.text(), before);
    return words;
}

TEST(SceneDocument, TakesEveryKindOfValue) {
    SceneDocument document = document_of(document_scene);
    document.set("motion.symmetric", true);
    document.set("spline.segments", 8.0);
    document.set("title", std::string("a \"title\""));
    document.set("motion.rise_deg", 90.5);
    document.set("motion.via", TomlValue{"[{ at = 0.25, displacement = 0.1 }]"});
    const Scene scene = document.scene();
    EXPECT_TRUE(scene.motion.symmetric);
    EXPECT_EQ(scene.spline.segments, 8);
    EXPECT_EQ(scene.title, "a \"title\"");
    ASSERT_EQ(scene.motion.via.size(), 1U);
    EXPECT_EQ(scene.motion.via[0].at, 0.25);
    document.set("motion.symmetric", false);
    document.set("spline.breakpoints", std::vector<double>{0, 0.25, 0.5, 1});
    EXPECT_EQ(document.scene().spline.breakpoints, (std::vector<double>{0, 0.25, 0.5, 1}));
    document.set("motion.via[0].at", 0.3);
    EXPECT_EQ(document.scene().motion.via[0].at, 0.3);
}

TEST(SceneDocument, ReplacesSynonymsAndRestoresDefaults) {
    SceneDocument document = document_of(document_scene);
    document.set("motion.lift_mm", 20);
    EXPECT_EQ(document.scene().motion.lift, 0.02);
    EXPECT_FALSE(says(document.text(), "lift_in"));
    document.unset("motion.lift_in");
    EXPECT_EQ(document.scene().motion.lift, Scene().motion.lift);
    document.unset("motion.lift_in");
    document.unset("cam");
    document.unset("solver.options.anything");
    document.set("motion.via",
                 TomlValue{"[{ at = 0.2, displacement = 0.1 }, { at = 0.6, displacement = 0.7 }]"});
    document.unset("motion.via[0]");
    ASSERT_EQ(document.scene().motion.via.size(), 1U);
    EXPECT_EQ(document.scene().motion.via[0].at, 0.6);
    document.unset("motion.via");
    EXPECT_TRUE(document.scene().motion.via.empty());
}

TEST(SceneDocument, RefusesInSceneFileWording) {
    SceneDocument document = document_of(document_scene);
    const auto set = [&](const std::string& key, const SceneValue& value) {
        return refused(document, [&] { document.set(key, value); });
    };
    EXPECT_EQ(set("spline.degree", 4), "spline.degree: found 4; allowed: 3, 5 or 7");
    EXPECT_TRUE(says(set("spline.segmnts", 4), "did you mean 'segments'?"));
    EXPECT_TRUE(says(set("spline.segments", 4.5), "spline.segments: found 4.5; allowed: "));
    EXPECT_TRUE(says(set("motion.lift_mm", std::nan("")), "found nan; allowed: "));
    EXPECT_TRUE(says(set("motion.lift_mm", std::numeric_limits<double>::infinity()), "found inf"));
    EXPECT_TRUE(says(set("motion.lift_mm", std::string("ten")), "found \"ten\"; allowed: "));
    EXPECT_TRUE(says(set("solver.name", std::string("structurd")), "did you mean"));
    EXPECT_TRUE(says(set("objective.reference", std::string("sine")), "a law of the catalogue"));
    EXPECT_TRUE(says(set("spline.end_jerk", std::string("zero")), "spline.end_jerk: found"));
    EXPECT_TRUE(says(set("motion.rise_deg", TomlValue{"ninety]"}), "motion.rise_deg: found no TOML value"));
    EXPECT_TRUE(says(set("a key", 1), "found \"a key\", which is not a dotted key"));
    EXPECT_TRUE(says(set("", 1), "not a dotted key"));
    EXPECT_TRUE(says(set("motion.via[0].at", 1), "motion.via"));
    EXPECT_TRUE(says(refused(document, [&] { document.unset("motion.lft_mm"); }), "did you mean 'lift_mm'?"));
}

TEST(SceneDocument, LeavesMissingKeysToReaders) {
    SceneDocument document = document_of("");
    document.set("cam.base_radius_mm", 30);
    document.set("objective.jerk", 1);
    EXPECT_THROW((void)document.scene(), InputError);
    document.set("motion.type", std::string("RR"));
    document.set("cam.type", std::string("disk"));
    document.set("cam.follower", std::string("translating_knife"));
    const Scene scene = document.scene();
    ASSERT_TRUE(scene.cam);
    EXPECT_EQ(scene.cam->find(DimensionIndex::base_radius)->low, 0.03);
}

TEST(SceneDocument, IsTheSceneOfItsText) {
    SceneDocument document = document_of(document_scene);
    EXPECT_EQ(document.text(), document_scene);
    document.set("motion.rise_rad", 0.1 + 0.2);
    const Scene again = read_scene(document.text(), "again", document_names);
    EXPECT_EQ(again.motion.rise, 0.1 + 0.2);
    EXPECT_EQ(again.motion.lift, 0.0254);
}

TEST(SceneDocument, ReadsSettingsOnTopAndCopies) {
    const SceneDocument document = document_of(document_scene);
    const std::vector<std::string> settings = {"spline.segments=9", "motion.lift_mm=5"};
    const Scene scene = document.scene(settings);
    EXPECT_EQ(scene.spline.segments, 9);
    EXPECT_EQ(scene.motion.lift, 0.005);
    EXPECT_EQ(document.scene().motion.lift, 0.0254);
    SceneDocument copy = document;
    copy.set("spline.segments", 7);
    EXPECT_EQ(document.scene().spline.segments, Scene().spline.segments);
    copy = document;
    EXPECT_EQ(copy.text(), document.text());
    EXPECT_THROW((void)document.scene(std::vector<std::string>{"spline.degree=4"}), InputError);
}

TEST(SceneDocument, RefusesWhatIsNoToml) {
    EXPECT_THROW(document_of("[motion\n"), InputError);
}

}  // namespace scene_document_test
}  // namespace camopt::input
