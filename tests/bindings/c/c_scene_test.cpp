// SPDX-License-Identifier: MIT
// Scenes through the C face: keys, words, NULLs.
#include "tests/bindings/c/c_face.hpp"

#include <cmath>
#include <string_view>
#include <thread>

namespace camopt {
namespace c_scene_test {

using namespace testing_support;

const char* error_words() {
    return camopt_error_text();
}

TEST(CScene, BuiltFromKeysEqualsFile) {
    camopt_scene* made = nullptr;
    ASSERT_EQ(camopt_scene_new(&made), CAMOPT_OK);
    const CScene scene(made);
    EXPECT_EQ(camopt_scene_check(made), CAMOPT_ERROR_INPUT);
    EXPECT_NE(std::string_view(error_words()).find("motion: missing; allowed: a [motion] table"),
              std::string_view::npos);
    EXPECT_OK(camopt_set_text(made, "motion.type", "DRD"));
    EXPECT_OK(camopt_set_number(made, "motion.lift_in", 1));
    EXPECT_OK(camopt_set_number(made, "motion.lift_mm", 10));
    EXPECT_OK(camopt_set_number(made, "motion.rise_deg", 120));
    EXPECT_OK(camopt_set_number(made, "spline.segments", 12));
    EXPECT_OK(camopt_set_number(made, "objective.velocity", 0.4));
    EXPECT_OK(camopt_set_number(made, "objective.acceleration", 0.4));
    EXPECT_OK(camopt_set_number(made, "objective.jerk", 0.2));
    EXPECT_OK(camopt_scene_check(made));
    EXPECT_EQ(toml_of(scene),
              "[motion]\ntype = \"DRD\"\nlift_mm = 10\nrise_deg = 120\n\n[spline]\nsegments = 12\n\n"
              "[objective]\nvelocity = 0.4\nacceleration = 0.4\njerk = 0.2\n");
    EXPECT_EQ(summary_of(c_solved(scene)).objective, summary_of(c_solved(c_scene(paper_toml))).objective);
}

TEST(CScene, SetsAndUnsetsEveryKind) {
    const CScene scene = c_scene(paper_toml);
    EXPECT_EQ(toml_of(scene), paper_toml);
    const double breakpoints[] = {0, 0.2, 0.5, 0.8, 1};
    EXPECT_OK(camopt_set_numbers(scene.get(), "spline.breakpoints", breakpoints, 5));
    EXPECT_OK(camopt_set_bool(scene.get(), "motion.symmetric", 7));
    EXPECT_OK(camopt_set_toml(scene.get(), "motion.via", "[{ at = 0.5, displacement = 0.5 }]"));
    EXPECT_OK(camopt_set_text(scene.get(), "title", "ä \"b\""));
    const std::string toml = toml_of(scene);
    EXPECT_NE(toml.find("breakpoints = [0, 0.2, 0.5, 0.8, 1]"), std::string::npos) << toml;
    EXPECT_NE(toml.find("symmetric = true"), std::string::npos) << toml;
    EXPECT_EQ(toml.find("segments"), std::string::npos) << toml;
    const CScene again = c_scene(toml);
    EXPECT_EQ(toml_of(again), toml);
    EXPECT_OK(camopt_unset(scene.get(), "spline.breakpoints"));
    EXPECT_OK(camopt_unset(scene.get(), "spline.breakpoints"));
    EXPECT_OK(camopt_set_bool(scene.get(), "motion.symmetric", 0));
    EXPECT_OK(camopt_unset(scene.get(), "motion.via"));
    EXPECT_EQ(toml_of(scene).find("via"), std::string::npos);
    EXPECT_OK(camopt_set_numbers(scene.get(), "spline.breakpoints", breakpoints, 5));
}

TEST(CScene, RefusalKeepsSceneAndFileWording) {
    const CScene scene = c_scene(paper_toml);
    camopt_scene* const s = scene.get();
    const double one = 0.5;
    EXPECT_EQ(camopt_set_number(s, "spline.degree", 4), CAMOPT_ERROR_INPUT);
    EXPECT_STREQ(error_words(), "spline.degree: found 4; allowed: 3, 5 or 7");
    EXPECT_EQ(camopt_set_number(s, "limits.velocty", 1), CAMOPT_ERROR_INPUT);
    EXPECT_NE(std::string_view(error_words()).find("did you mean"), std::string_view::npos) << error_words();
    EXPECT_EQ(camopt_set_number(s, "limits.velocity_mm_s", 300), CAMOPT_ERROR_INPUT);
    EXPECT_NE(std::string_view(error_words()).find("speed"), std::string_view::npos) << error_words();
    EXPECT_EQ(camopt_set_number(s, "motion.lift_mm", std::nan("")), CAMOPT_ERROR_INPUT);
    EXPECT_EQ(camopt_set_text(s, "solver.name", "none"), CAMOPT_ERROR_INPUT);
    EXPECT_EQ(camopt_set_bool(s, "motion.lift_mm", 1), CAMOPT_ERROR_INPUT);
    EXPECT_EQ(camopt_set_numbers(s, "spline.breakpoints", &one, 1), CAMOPT_ERROR_INPUT);
    EXPECT_EQ(camopt_set_numbers(s, "spline.breakpoints", nullptr, 0), CAMOPT_ERROR_INPUT);
    EXPECT_EQ(camopt_set_toml(s, "motion.via", "[{"), CAMOPT_ERROR_INPUT);
    EXPECT_EQ(camopt_unset(s, "motion.lft"), CAMOPT_ERROR_INPUT);
    EXPECT_EQ(toml_of(scene), paper_toml);
    EXPECT_OK(camopt_set_number(s, "motion.speed_rpm", 300));
    EXPECT_OK(camopt_set_number(s, "limits.velocity_mm_s", 300));
}

TEST(CScene, FilesAndTextsReportTheirLocation) {
    camopt_scene* scene = nullptr;
    EXPECT_EQ(camopt_scene_from_toml("[motion]\ntype = \"DRD\"\nlift_mm = -1\n", "press.toml", &scene),
              CAMOPT_ERROR_INPUT);
    EXPECT_EQ(scene, nullptr);
    EXPECT_EQ(std::string_view(error_words()).substr(0, 30), "press.toml:3:11: motion.lift_m");
    EXPECT_EQ(camopt_scene_from_toml("[motion", nullptr, &scene), CAMOPT_ERROR_INPUT);
    EXPECT_EQ(std::string_view(error_words()).substr(0, 8), "scene:1:");
    EXPECT_EQ(camopt_scene_from_file("/no/such/scene.toml", &scene), CAMOPT_ERROR_INPUT);
    EXPECT_EQ(std::string_view(error_words()).substr(0, 36), "/no/such/scene.toml: cannot be read:");
    EXPECT_EQ(scene, nullptr);
}

TEST(CScene, CopiesAreTheirOwn) {
    const CScene scene = c_scene(paper_toml);
    camopt_scene* made = nullptr;
    ASSERT_EQ(camopt_scene_copy(scene.get(), &made), CAMOPT_OK);
    const CScene copy(made);
    EXPECT_OK(camopt_set_number(copy.get(), "spline.segments", 4));
    EXPECT_EQ(toml_of(scene), paper_toml);
    EXPECT_NE(toml_of(copy), paper_toml);
}

TEST(CScene, RefusesNulls) {
    const CScene scene = c_scene(paper_toml);
    camopt_scene* const s = scene.get();
    camopt_scene* made = nullptr;
    camopt_text text{};
    const camopt_error codes[] = {camopt_scene_new(nullptr),
                                  camopt_scene_from_toml(nullptr, "a", &made),
                                  camopt_scene_from_toml("", "a", nullptr),
                                  camopt_scene_from_file(nullptr, &made),
                                  camopt_scene_from_file("a", nullptr),
                                  camopt_scene_copy(nullptr, &made),
                                  camopt_scene_copy(s, nullptr),
                                  camopt_set_number(nullptr, "spline.degree", 3),
                                  camopt_set_number(s, nullptr, 3),
                                  camopt_set_text(nullptr, "title", "a"),
                                  camopt_set_text(s, nullptr, "a"),
                                  camopt_set_text(s, "title", nullptr),
                                  camopt_set_bool(nullptr, "motion.symmetric", 1),
                                  camopt_set_bool(s, nullptr, 1),
                                  camopt_set_numbers(nullptr, "spline.breakpoints", nullptr, 0),
                                  camopt_set_numbers(s, nullptr, nullptr, 0),
                                  camopt_set_numbers(s, "spline.breakpoints", nullptr, 2),
                                  camopt_set_toml(nullptr, "title", "a"),
                                  camopt_set_toml(s, nullptr, "a"),
                                  camopt_set_toml(s, "title", nullptr),
                                  camopt_unset(nullptr, "title"),
                                  camopt_unset(s, nullptr),
                                  camopt_scene_check(nullptr),
                                  camopt_scene_to_toml(nullptr, &text),
                                  camopt_scene_to_toml(s, nullptr)};
    for (std::size_t i = 0; i < std::size(codes); ++i) EXPECT_EQ(codes[i], CAMOPT_ERROR_NULL) << i;
    EXPECT_STREQ(error_words(), "toml: found NULL; allowed: a pointer to it");
    EXPECT_EQ(made, nullptr);
    EXPECT_EQ(text.data, nullptr);
    EXPECT_EQ(toml_of(scene), paper_toml);
    camopt_scene_free(nullptr);
    camopt_solution_free(nullptr);
    camopt_text_free(nullptr);
    camopt_text_free(&text);
}

TEST(CError, TextsBelongToTheirThread) {
    ASSERT_EQ(camopt_scene_new(nullptr), CAMOPT_ERROR_NULL);
    const std::string here = camopt_error_text();
    std::string before, there;
    std::thread([&] {
        before = camopt_error_text();
        (void)camopt_scene_check(nullptr);
        (void)camopt_scene_from_toml("x", nullptr, nullptr);
        camopt_scene* scene = nullptr;
        (void)camopt_scene_from_toml("= 1", "there", &scene);
        there = camopt_error_text();
    }).join();
    EXPECT_EQ(before, "");
    EXPECT_EQ(there.substr(0, 8), "there:1:");
    EXPECT_EQ(camopt_error_text(), here);
}

TEST(CError, NamesAndVersions) {
    EXPECT_EQ(camopt_abi_version(), CAMOPT_ABI_VERSION);
    EXPECT_EQ(std::string(camopt_version()).substr(0, 2), "0.");
    const std::string licenses = camopt_licenses();
    EXPECT_EQ(licenses.substr(0, 13), "camopt: MIT (");
    EXPECT_NE(licenses.find("\nA binary of this build"), std::string::npos) << licenses;
    const char* const names[] = {"ok",       "null",      "argument", "input",  "unavailable", "absent",
                                 "capacity", "cancelled", "callback", "memory", "internal"};
    for (int code = 0; code < static_cast<int>(std::size(names)); ++code)
        EXPECT_STREQ(camopt_error_name(static_cast<camopt_error>(code)), names[code]);
    EXPECT_STREQ(camopt_error_name(static_cast<camopt_error>(15)), "unknown");
    EXPECT_STREQ(camopt_verdict_name(CAMOPT_OPTIMAL), "optimal");
    EXPECT_STREQ(camopt_verdict_name(CAMOPT_LOCAL), "local");
    EXPECT_STREQ(camopt_verdict_name(CAMOPT_FEASIBLE), "feasible");
    EXPECT_STREQ(camopt_verdict_name(CAMOPT_INFEASIBLE), "infeasible");
    EXPECT_STREQ(camopt_verdict_name(CAMOPT_FAILED), "failed");
    EXPECT_STREQ(camopt_verdict_name(static_cast<camopt_verdict>(7)), "unknown");
}

}  // namespace c_scene_test
}  // namespace camopt
