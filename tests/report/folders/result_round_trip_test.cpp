// SPDX-License-Identifier: MIT
// Results of every kind of cam, of random scenes, written and read back: every number is the same, and what
// was changed afterwards is refused.
#include "core/errors.hpp"
#include "core/text/text_file.hpp"
#include "input/loading/load_scene.hpp"
#include "input/scene_reader.hpp"
#include "report/folders/result_folder_reader.hpp"
#include "report/json/certificate_json.hpp"
#include "report/json/result_json.hpp"
#include "studies/checked/checked_cam.hpp"
#include "studies/solve/solve.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/source_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace camopt {
namespace result_round_trip_test {

using Json = nlohmann::ordered_json;
using testing_support::refusal;
using testing_support::says;

Scene loaded(const std::string& text, const std::string& name,
             const std::vector<std::string>& settings = {}) {
    Scene scene = input::read_scene(text, name, known_names(), settings);
    return scene;
}

ResultFolder read_back(const std::filesystem::path& folder) {
    return read_result_folder(
        folder, [](const std::string& text, const std::string& name) { return loaded(text, name); });
}

/// A scene of this project with these settings, solved and written; what was delivered.
Solution solved_into(const std::filesystem::path& folder, const std::string& name,
                     const std::vector<std::string>& settings) {
    const std::string file = source_folder() + "/scenes/" + name + ".toml";
    const std::string text = read_text_file(file);
    Solution solution = solve(loaded(text, file, settings));
    if (solution.cam) solution.cam->forward_check = checked_cam(solution, 200);
    const RunOrigin origin{file, "camopt solve …", input::scene_with_overrides(text, file, settings)};
    write_result_folder(folder, solution, origin);
    return solution;
}

void expect_same_motion(const MotionChain& one, const MotionChain& other) {
    ASSERT_EQ(one.parts().size(), other.parts().size());
    ASSERT_EQ(one.breakpoints(), other.breakpoints());
    for (int i = 0; i <= 500; ++i) {
        const double x = one.begin() + (one.end() - one.begin()) * i / 500.0;
        for (const Side side : {Side::left, Side::right})
            EXPECT_EQ(one.at(x, side).derivative, other.at(x, side).derivative) << "x = " << x;
    }
}

struct Case {
    std::string name, scene, lift_key;
    double lift;
    unsigned segments;  ///< at least
    std::vector<std::string> settings;
    friend void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }
};

class RoundTrip : public testing::TestWithParam<Case> {};

TEST_P(RoundTrip, EveryNumberIsTheSame) {
    const Case& one = GetParam();
    std::mt19937 random(
        static_cast<unsigned>(one.name.size() + 31U * static_cast<unsigned char>(one.name[0])));
    for (int again = 0; again < 2; ++again) {
        const test::TemporaryFolder folder;
        std::vector<std::string> settings = one.settings;
        const double lift = one.lift * std::uniform_real_distribution(0.85, 1.0)(random);
        settings.push_back(fmt::format("motion.{}={}", one.lift_key, lift));
        settings.push_back(fmt::format("spline.segments={}", one.segments + random() % 5));
        const Solution solution = solved_into(folder.path(), one.scene, settings);
        ASSERT_TRUE(solution.motion) << "lift " << lift;
        const ResultFolder read = read_back(folder.path());
        EXPECT_EQ(result_json(read.solution, read.origin), read_text_file(folder.path() + "/result.json"));
        EXPECT_EQ(certificate_json(read.solution.certificate),
                  read_text_file(folder.path() + "/certificate.json"));
        expect_same_motion(*solution.motion, *read.solution.motion);
        ASSERT_EQ(solution.cam.has_value(), read.solution.cam.has_value());
        if (solution.cam) {
            EXPECT_EQ(solution.cam->cam.dimensions, read.solution.cam->cam.dimensions);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, RoundTrip,
    testing::ValuesIn(std::vector<Case>{
        {"rise", "drd_cubic_12", "lift_mm", 10.0, 8, {}},
        {"quintic", "drd_quintic_12", "lift_mm", 10.0, 8, {"motion.speed_rpm=317.7"}},
        {"free_breakpoints", "drd_free_knots", "lift_mm", 10.0, 8, {"solver.starts=1"}},
        {"return", "rr_unequal_return", "lift_mm", 12.0, 8, {}},
        {"roller", "cam_roller", "lift_mm", 10.0, 16, {"solver.starts=1"}},
        {"knife", "cam_knife", "lift_mm", 6.0, 8, {"solver.starts=1"}},
        {"flat", "cam_flat", "lift_mm", 9.0, 16, {"solver.starts=1"}},
        {"arm_roller", "cam_arm_roller", "lift_deg", 20.0, 8, {"solver.starts=1"}},
        {"arm_flat", "cam_arm_flat", "lift_deg", 14.0, 8, {"solver.starts=1"}},
        {"forces", "cam_forces", "lift_mm", 12.0, 8, {"solver.starts=1"}},
        {"chosen_spring",
         "cam_forces",
         "lift_mm",
         12.0,
         8,
         {"solver.starts=1", "forces.preload_n={min=20,max=400}"}},
        {"groove", "cam_grooved", "lift_mm", 25.0, 12, {"solver.starts=1"}},
        {"conjugate", "cam_conjugate", "lift_deg", 20.0, 12, {"solver.starts=1"}},
        {"smallest", "cam_smallest", "lift_mm", 10.0, 8, {"solver.starts=1"}},
        {"program", "cam_laws_and_splines", "lift_mm", 15.0, 8, {"solver.starts=1"}},
        {"set_points", "pusher_set_points", "lift_mm", 60.0, 20, {}},
        {"searched_angles", "program_constant_velocity", "lift_mm", 60.0, 8, {}},
        {"remote", "tappet_75", "lift_mm", 80.0, 8, {"solver.starts=1"}},
        {"barrel", "barrel_paper_cup", "lift_deg", 51.4, 8, {"solver.starts=1"}},
        {"barrel_dimensions", "barrel_smallest", "lift_deg", 40.0, 8, {"solver.starts=1"}},
        {"cylinder_slide", "cylinder_slide", "lift_mm", 40.0, 8, {"solver.starts=1"}},
        {"cylinder_turn", "ocrf_indexing", "lift_deg", 45.0, 8, {"solver.starts=1"}},
        {"drum", "cylinder_drum", "lift_mm", 40.0, 8, {"solver.starts=1"}},
        {"inverse", "inverse_feeder", "lift_in", 2.694, 8, {"solver.starts=1"}},
    }),
    [](const auto& one) { return one.param.name; });

// A result folder holds the table that its scene named.
TEST(RoundTripOfATable, FolderIsComplete) {
    const test::TemporaryFolder folder;
    const std::filesystem::path file = source_folder() + "/scenes/drd_measured.toml";
    const Solution solution = solve(input::read_scene_file(file, known_names()));
    ASSERT_TRUE(solution.measured);
    write_result_folder(folder.path(), solution,
                        {file.string(), "camopt solve …", input::whole_scene_text(file)});
    const ResultFolder read = read_back(folder.path());
    ASSERT_TRUE(read.solution.measured);
    EXPECT_EQ(read.solution.measured->largest_error, solution.measured->largest_error);
    EXPECT_EQ(result_json(read.solution, read.origin), read_text_file(folder.path() + "/result.json"));
}

// What the scene says goes through text: a scene with settings is written anew, and is the same scene.
TEST(SceneText, SettingsAreMergedIntoOneText) {
    const std::string text =
        "title = \"a \\\"b\\\" \\\\ \\u0007\"\n[motion]\ntype = \"DRD\"\nlift_mm = 1e1\nrise_deg = 0.1\n"
        "via = [{ at = 0.25, displacement = 0.1 }]\n[spline]\nbreakpoints = [0, 0.3333333333333333, 1]\n"
        "[objective]\nvelocity = 1\nreference = { velocity = 2, jerk = 3.5e-300 }\n";
    const std::vector<std::string> settings = {"motion.rise_rad=0.30000000000000004", "spline.degree=5"};
    const std::string whole = input::scene_with_overrides(text, "a.toml", settings);
    const Scene one = input::read_scene(text, "a.toml", known_names(), settings);
    const Scene other = input::read_scene(whole, "b.toml", known_names());
    EXPECT_EQ(one.title, other.title);
    EXPECT_EQ(one.motion.lift, other.motion.lift);
    EXPECT_EQ(other.motion.rise, 0.30000000000000004);
    EXPECT_EQ(one.spline.breakpoints, other.spline.breakpoints);
    EXPECT_EQ(other.spline.degree, 5);
    EXPECT_EQ(other.objective.reference.jerk, 3.5e-300);
    ASSERT_EQ(other.motion.via.size(), 1U);
    EXPECT_EQ(other.motion.via[0].displacement, 0.1);
    // Written again it is the same text, and without settings it is the given one.
    EXPECT_EQ(input::scene_with_overrides(text, "a.toml", {}), text);
    const std::vector<std::string> same = {"spline.degree=5"};
    const auto without_comment = [](const std::string& full) { return full.substr(full.find('\n')); };
    EXPECT_EQ(without_comment(input::scene_with_overrides(whole, "a.toml", same)), without_comment(whole));
}

class ChangedFolder : public testing::Test {
 protected:
    static void SetUpTestSuite() {
        folder_ = new test::TemporaryFolder;
        (void)solved_into(folder_->path(), "cam_drdrd", {"solver.starts=1", "spline.segments=8"});
    }
    static void TearDownTestSuite() {
        delete folder_;
        folder_ = nullptr;
    }
    void SetUp() override {
        copy_ = std::filesystem::path(folder_->path()) / "copy";
        std::filesystem::remove_all(copy_);
        std::filesystem::create_directory(copy_);
        for (const char* const name : {"scene.toml", "result.json", "certificate.json"})
            std::filesystem::copy(std::filesystem::path(folder_->path()) / name, copy_ / name);
    }
    /// What is said of the folder with this change in result.json.
    template <class Change>
    std::string refused_with(const Change& change) {
        Json json = Json::parse(read_text_file(copy_ / "result.json"));
        change(json);
        write_text_file(copy_ / "result.json", json.dump());
        return refused();
    }
    std::string refused() {
        return refusal([&] { (void)read_back(copy_); }, "");
    }
    void replace(const char* name, const std::string& old_words, const std::string& new_words) {
        std::string text = read_text_file(copy_ / name);
        const std::size_t at = text.find(old_words);
        ASSERT_NE(at, std::string::npos) << old_words;
        write_text_file(copy_ / name, text.replace(at, old_words.size(), new_words));
    }

    static inline test::TemporaryFolder* folder_ = nullptr;
    std::filesystem::path copy_;
};

TEST_F(ChangedFolder, UnchangedItIsTaken) {
    EXPECT_EQ(refused(), "");
    EXPECT_EQ(refused_with([](Json&) {}), "");  // another layout is no other result
}

TEST_F(ChangedFolder, AMissingFile) {
    std::filesystem::remove(copy_ / "scene.toml");
    EXPECT_TRUE(says(refused(), "found no scene.toml"));
    std::filesystem::remove(copy_ / "result.json");
    EXPECT_TRUE(says(refused(), "found no result.json"));
}

TEST_F(ChangedFolder, FilesOfTwoRuns) {
    write_text_file(copy_ / "INCOMPLETE.txt", "");
    EXPECT_TRUE(says(refused(), "INCOMPLETE.txt"));
}

TEST_F(ChangedFolder, AnotherVersion) {
    EXPECT_TRUE(says(refused_with([](Json& json) { json["camopt"] = "0.0.1"; }), "camopt 0.0.1"));
}

TEST_F(ChangedFolder, Numbers) {
    const auto changed = [&](const std::string& words, const auto& change) {
        SetUp();
        EXPECT_TRUE(says(refused_with(change), words));
    };
    changed("objective", [](Json& json) { json["objective"] = json["objective"].get<double>() + 1e-6; });
    changed("peaks.jerk.value", [](Json& json) { json["peaks"]["jerk"]["value"] = 1.0; });
    changed("cam.dimensions", [](Json& json) { json["cam"]["dimensions"]["base_radius_m"] = 0.5; });
    changed("cam.pressure_angle_deg", [](Json& json) { json["cam"]["pressure_angle_deg"]["value"] = 5.0; });
    changed("cam.type: found \"barrel\"", [](Json& json) { json["cam"]["type"] = "barrel"; });
    changed("verdict", [](Json& json) { json["verdict"] = "feasible"; });
    changed("remark: found an unknown key", [](Json& json) { json["remark"] = "mine"; });
    changed("title: found no such key", [](Json& json) { json.erase("title"); });
    changed("motion.curves[0].degree", [](Json& json) { json["motion"]["curves"][0]["degree"] = 4; });
    changed("parts", [](Json& json) { json["motion"]["parts"].erase(0); });
    changed("as computed from the motion and its scene", [](Json& json) {
        double& number = json["motion"]["curves"][0]["pieces"][3][2].get_ref<double&>();
        number *= 1.0 + 1e-6;
    });
    changed("motion: found none", [](Json& json) { json["motion"] = nullptr; });
}

TEST_F(ChangedFolder, AnotherScene) {
    replace("scene.toml", "lift_mm = ", "lift_mm = 1");
    EXPECT_TRUE(says(refused(), "as computed from the motion and its scene"));
    SetUp();
    replace("scene.toml", "segments = [", "segments = [{kind=\"dwell\", angle_deg=1},");
    EXPECT_NE(refused(), "");
    SetUp();
    replace("scene.toml", "[motion]", "[motion");
    EXPECT_TRUE(says(refused(), "scene.toml:"));
}

TEST_F(ChangedFolder, NoJson) {
    write_text_file(copy_ / "result.json", "{");
    EXPECT_TRUE(says(refused(), "found no JSON"));
}

TEST(ResultFolderReader, InfeasibleSceneHasNoMotion) {
    const test::TemporaryFolder folder;
    const Solution solution = solved_into(folder.path(), "infeasible_velocity_cap", {});
    ASSERT_FALSE(solution.motion);
    EXPECT_TRUE(says(refusal([&] { (void)read_back(folder.path()); }), "the verdict is infeasible"));
}

}  // namespace result_round_trip_test
}  // namespace camopt
