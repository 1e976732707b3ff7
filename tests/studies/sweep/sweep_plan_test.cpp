// SPDX-License-Identifier: MIT
// The rows of a sweep: the grid, the scene of every row, the check before anything is solved.
#include "studies/sweep/sweep_plan.hpp"

#include "core/errors.hpp"
#include "input/loading/load_scene.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace camopt {
namespace sweep_plan_test {

using testing_support::refusal;
using testing_support::says;

constexpr const char* plain_scene =
    "[motion]\ntype = \"DRD\"\n[spline]\nsegments = 8\n[objective]\nvelocity = 0.4\nacceleration = 0.4\n"
    "jerk = 0.2\n";
constexpr const char* cam_scene =
    "[motion]\ntype = \"DRD\"\nlift_mm = 20\nrise_deg = 60\n[objective]\nvelocity = 1\n"
    "[cam]\ntype = \"disk\"\nfollower = \"translating_roller\"\nbase_radius_mm = { min = 20, max = 60 }\n"
    "roller_radius_mm = 10\n[limits]\npressure_angle_deg = 30\n";

/// Reads the text, and counts how often.
class Reader {
 public:
    explicit Reader(std::string text) : text_(std::move(text)) {}
    SceneReading reading() {
        return [this](std::span<const std::string> settings) {
            ++count;
            return scene_of_toml(text_, settings, "s.toml");
        };
    }
    int count = 0;

 private:
    std::string text_;
};

std::vector<double> row(const SweepPlan& plan, int number) {
    const auto values = plan.row(number);
    return {values.begin(), values.end()};
}

TEST(SweepGrid, IsCompleteAndAxesMoveSeparately) {
    const std::vector<SweepAxis> axes = {varied_key("a=1:3:3"), varied_key("b=10,20"), simplex_weights(3)};
    const SweepPlan plan = sweep_grid(axes);
    EXPECT_EQ(plan.keys, (std::vector<std::string>{"a", "b", "objective.velocity", "objective.acceleration",
                                                   "objective.jerk"}));
    ASSERT_EQ(plan.rows(), 3 * 2 * 10);
    std::set<std::vector<double>> seen;
    for (int i = 0; i < plan.rows(); ++i) {
        EXPECT_TRUE(seen.insert(row(plan, i)).second) << "row " << i;
        if (i == 0) continue;
        const std::vector<double> now = row(plan, i), before = row(plan, i - 1);
        const bool a = now[0] != before[0], b = now[1] != before[1];
        const bool weights =
            std::vector(now.begin() + 2, now.end()) != std::vector(before.begin() + 2, before.end());
        EXPECT_EQ(a + b + weights, 1) << "row " << i;
        if (a) {
            EXPECT_NEAR(std::abs(now[0] - before[0]), 1.0, 1e-12);
        }
    }
    EXPECT_EQ(row(plan, 0)[0], 1.0);
    EXPECT_EQ(row(plan, plan.rows() - 1)[0], 3.0);  // the first axis moves slowest
}

TEST(SweepGrid, RefusesEmptyDuplicateAndExcessiveKeys) {
    const auto said = [](const std::vector<SweepAxis>& axes) {
        return refusal([&] { (void)sweep_grid(axes); });
    };
    EXPECT_TRUE(says(said({}), "allowed: --weights, --vary"));
    EXPECT_TRUE(says(said({varied_key("a=1,2"), SweepAxis{{"b"}, {}}}), "an axis without points"));
    EXPECT_TRUE(says(said({varied_key("a=1,2"), varied_key("a=3,4")}), "a: varied twice"));
    EXPECT_TRUE(
        says(said({varied_key("objective.jerk=1,2"), simplex_weights(2)}), "objective.jerk: varied twice"));
    EXPECT_TRUE(says(said({varied_key("a=1:2:2000"), varied_key("b=1:2:2000")}), "at most 1000000"));
    EXPECT_EQ(said({varied_key("a=1:2:1000"), varied_key("b=1:2:1000")}), "no refusal");
}

TEST(SweepGrid, FingerprintDistinguishesPlans) {
    const auto of = [](const char* text) { return fingerprint(sweep_grid(std::vector{varied_key(text)})); };
    const std::set<std::string> all = {of("a=1,2"), of("a=2,1"), of("b=1,2"), of("a=1,2,3"),
                                       of("a=1,2.0000000000000004")};
    EXPECT_EQ(all.size(), 5U);
    EXPECT_EQ(of("a=1,2"), of("a=1:2:2"));
    EXPECT_EQ(of("a=1,2").size(), 16U);
}

TEST(SettingText, IsEquivalentTomlValue) {
    EXPECT_EQ(setting_text("spline.segments", 24.0), "spline.segments=24");
    EXPECT_EQ(setting_text("a.b", 0.1), "a.b=0.1");
    EXPECT_EQ(setting_text("a.b", -2.5e-9), "a.b=-2.5e-09");
    EXPECT_EQ(setting_text("a.b", 1.0 / 3.0), "a.b=0.3333333333333333");
    Reader reader(plain_scene);
    for (const double value : {1.0 / 3.0, 2.5e-9, 1e300, 5e-324, 1e15, 123456789012345.0})
        EXPECT_EQ(reader.reading()(std::vector{setting_text("objective.jerk", value)}).objective.jerk, value);
}

TEST(SweepScenes, WeightsAreReadOnce) {
    Reader reader(cam_scene);
    SweepPlan plan = sweep_grid(std::vector{
        varied_key("cam.roller_radius_mm=8,12"),
        weights_of_csv("velocity,jerk,rms_jerk,base_radius\n1,0,0,0\n0.3,0.1,0.2,0.4\n0,0,0,1\n", "w")});
    SweepScenes scenes(plan, reader.reading());
    for (int i = 0; i < plan.rows(); ++i) {
        SCOPED_TRACE(i);
        const Scene scene = scenes.scene(i);
        std::vector<std::string> settings;
        for (std::size_t k = 0; k < plan.keys.size(); ++k)
            settings.push_back(setting_text(plan.keys[k], plan.row(i)[k]));
        const Scene read = Reader(cam_scene).reading()(settings);
        EXPECT_EQ(scene.objective.velocity, read.objective.velocity);
        EXPECT_EQ(scene.objective.jerk, read.objective.jerk);
        EXPECT_EQ(scene.objective.rms_jerk, read.objective.rms_jerk);
        EXPECT_EQ(scene.objective.dimensions, read.objective.dimensions);
        EXPECT_EQ(scene.cam->find(DimensionIndex::roller_radius)->low,
                  read.cam->find(DimensionIndex::roller_radius)->low);
    }
    EXPECT_EQ(reader.count, 2);  // once a roller
}

TEST(SweepScenes, LimitsOnPeaksAreReadOnce) {
    const std::string limited = std::string(plain_scene) + "[limits]\nvelocity = 2\njerk = 80\n";
    Reader reader(limited.c_str());
    const SweepPlan plan =
        sweep_grid(std::vector{varied_key("limits.velocity=1.6:2:3"), varied_key("limits.jerk=60,70")});
    SweepScenes scenes(plan, reader.reading());
    for (int i = 0; i < plan.rows(); ++i) {
        SCOPED_TRACE(i);
        const Scene scene = scenes.scene(i);
        const Scene read = Reader(limited.c_str()).reading()(settings_of(plan.keys, plan.row(i)));
        EXPECT_EQ(scene.limits, read.limits);
    }
    EXPECT_EQ(reader.count, 1);
}

TEST(SweepScenes, NamesInvalidRowWithItsValues) {
    const auto said = [](const std::vector<SweepAxis>& axes, const char* text = plain_scene) {
        Reader reader(text);
        const SweepPlan plan = sweep_grid(axes);
        SweepScenes scenes(plan, reader.reading());
        return refusal([&] { (void)check_rows(scenes); });
    };
    EXPECT_EQ(said({varied_key("spline.segments=4:9:3")}),
              "row 1 (spline.segments=6.5): --set spline.segments=6.5: spline.segments: found 6.5; allowed: "
              "an integer from 1 to 65536");
    EXPECT_TRUE(says(said({varied_key("spline.sections=4,8")}), "row 0 (spline.sections=4): --set"));
    EXPECT_TRUE(says(said({weights_of_csv("velocity,acceleration,jerk\n1,0,0\n0,0,0\n", "w")}), "row 1 ("));
    EXPECT_TRUE(says(said({weights_of_csv("velocity,acceleration,jerk\n1,0,0\n0,0,0\n", "w")}),
                     "found no weight > 0; allowed: at least one"));
    EXPECT_TRUE(
        says(said({weights_of_csv("base_radius\n0\n1\n", "w")}), "row 1 (objective.base_radius=1): "));
    // The parabolic law has no finite jerk: a weight on it has no meaning.
    const std::string parabolic = std::string(plain_scene) + "reference = \"parabolic\"\n";
    EXPECT_TRUE(says(said({weights_of_csv("velocity,jerk\n1,0\n0.5,0.5\n", "w")}, parabolic.c_str()),
                     "row 1 (objective.velocity=0.5, objective.jerk=0.5): "));
    EXPECT_EQ(said({weights_of_csv("velocity,jerk\n1,0\n0.5,0\n", "w")}, parabolic.c_str()), "no refusal");
    EXPECT_TRUE(says(said({varied_key("limits.velocity=1.8,0")}), "row 1 (limits.velocity=0): "));
}

TEST(SweepScenes, RowAfterInvalidOneIsCorrect) {
    Reader reader(plain_scene);
    const SweepPlan plan =
        sweep_grid(std::vector{weights_of_csv("velocity,acceleration,jerk\n1,0,0\n0,0,0\n0,0,1\n", "w")});
    SweepScenes scenes(plan, reader.reading());
    EXPECT_EQ(scenes.scene(0).objective.velocity, 1.0);
    EXPECT_THROW((void)scenes.scene(1), InputError);
    EXPECT_EQ(scenes.scene(2).objective.velocity, 0.0);
    EXPECT_EQ(scenes.scene(2).objective.jerk, 1.0);
}

TEST(SweepCheck, ReportsWhatRowsShare) {
    Reader reader(cam_scene);
    const SweepPlan plan = sweep_grid(std::vector{
        weights_of_csv("velocity,jerk,rms_jerk,base_radius\n1,0,0,0\n0.5,0,0.5,0\n0,0,0,1\n", "w")});
    SweepScenes scenes(plan, reader.reading());
    const SweepColumns columns = check_rows(scenes);
    EXPECT_EQ(columns.keys, plan.keys);
    EXPECT_EQ(columns.dimensions, std::vector{DimensionIndex::base_radius});
    EXPECT_EQ(columns.criteria, (std::vector<std::string>{"velocity", "rms_jerk", "base_radius"}));
}

TEST(SweepCheck, TenThousandWeightsAreReadOnce) {
    Reader reader(plain_scene);
    const SweepPlan plan = sweep_grid(std::vector{simplex_weights(140)});
    ASSERT_EQ(plan.rows(), 10011);
    SweepScenes scenes(plan, reader.reading());
    EXPECT_EQ(check_rows(scenes).criteria, (std::vector<std::string>{"velocity", "acceleration", "jerk"}));
    EXPECT_EQ(reader.count, 1);
}

}  // namespace sweep_plan_test
}  // namespace camopt
