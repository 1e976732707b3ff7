// SPDX-License-Identifier: MIT
// What docs/embedding.md promises to programs with several threads: solves at once are the same as solves one
// after another, and what they share is not written to while it is evaluated. The preset tsan looks on.
#include "objectives/scene_model.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <thread>
#include <vector>

namespace camopt {
namespace threads_test {

using namespace testing_support;

constexpr int threads = 2;

/// Every one of them at once.
void at_once(const std::function<void(int)>& work) {
    std::vector<std::thread> running;
    for (int k = 0; k < threads; ++k) running.emplace_back(work, k);
    for (std::thread& thread : running) thread.join();
}

Scene plain_scene() {
    return scene_named("drd_cubic_8");
}

Scene roller_scene() {
    return pressure_angle_scene(60.0, 8).with("solver.starts = 1");
}

/// Its formulas are shared by all copies of the scene.
Scene linkage_scene() {
    return scene_named("lever_coupler_slider").with("solver.starts = 1", "limits.pressure_angle_deg = 45");
}

void expect_the_same(const Solution& one, const Solution& other) {
    EXPECT_EQ(one.certificate.verdict, other.certificate.verdict);
    EXPECT_EQ(one.certificate.objective, other.certificate.objective);
    EXPECT_EQ(one.evaluations.profile_points, other.evaluations.profile_points);
    ASSERT_TRUE(one.curve && other.curve);
    EXPECT_EQ(one.curve->coefficients(), other.curve->coefficients());
}

void expect_side_by_side(const Scene& scene) {
    const Solution alone = solve(scene);
    std::vector<Solution> found(threads);
    at_once([&](int k) { found[static_cast<std::size_t>(k)] = solve(scene); });
    for (const Solution& solution : found) expect_the_same(alone, solution);
}

TEST(Threads, SolveOneSceneAtOnce) {
    expect_side_by_side(plain_scene());
}

TEST(Threads, SolveOneCamAtOnce) {
    expect_side_by_side(roller_scene());
}

TEST(Threads, SolveLinkageConcurrentlyWithSharedFormulas) {
    expect_side_by_side(linkage_scene());
}

TEST(Threads, SolveTwoScenesAtOnce) {
    const std::vector<Scene> scenes = {plain_scene(), roller_scene()};
    std::vector<Solution> found(threads);
    at_once([&](int k) {
        const auto at = static_cast<std::size_t>(k);
        found[at] = solve(scenes[at]);
    });
    for (std::size_t k = 0; k < scenes.size(); ++k) expect_the_same(solve(scenes[k]), found[k]);
}

/// All rules of one model at many points; the sum of what they are.
double evaluated(const CamModel& model, int points) {
    double sum = 0.0;
    for (int i = 0; i < points; ++i) {
        const double x = (i + 0.5) / points;
        const MotionPoint point{x, {x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x), 6.0 - 12.0 * x, -12.0}};
        for (const PlacedRule& rule : model.rules) {
            const auto size = static_cast<Eigen::Index>(rule->parameters().size());
            sum += rule->evaluate(point, Eigen::VectorXd::Ones(size)).value;
        }
    }
    return sum;
}

TEST(Threads, EvaluateOneModelConcurrently) {
    constexpr int points = 2000;
    for (const Scene& scene : {roller_scene(), linkage_scene()}) {
        const CamModel model = scene_model(scene, DesignKind::states, reference_peaks(scene));
        const auto& counted = *model.cam->profile_points;
        const double alone = evaluated(model, points);
        const long once = counted;
        ASSERT_GT(once, 0);
        std::vector<double> sums(threads);
        at_once([&](int k) { sums[static_cast<std::size_t>(k)] = evaluated(model, points); });
        for (const double sum : sums) EXPECT_EQ(sum, alone);
        EXPECT_EQ(counted, (1 + threads) * once);
    }
}

}  // namespace threads_test
}  // namespace camopt
