// SPDX-License-Identifier: MIT
// The surface holds for weights that it was not solved at, says no more than it knows, and goes on where it
// was left.
#include "studies/surface/trade_off_surface.hpp"

#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/long_run.hpp"
#include "tests/support/refusal.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {
namespace trade_off_surface_test {

using namespace testing_support;

PeakTriple random_weights(std::mt19937& random) {
    PeakTriple weights{};
    for (double& weight : weights) weight = -std::log((static_cast<double>(random()) + 0.5) / 4294967296.0);
    const double sum = weights[0] + weights[1] + weights[2];
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// Solves what the surface was not solved at.
void expect_it_holds(const Scene& scene, const TradeOffSurface& surface, int trials) {
    std::mt19937 random(5);
    for (int k = 0; k < trials; ++k) {
        const PeakTriple weights = random_weights(random);
        const double objective = solve(with_weights(scene, weights)).certificate.objective;
        const SurfaceValue value = surface.at(weights);
        EXPECT_LE(value.lower, objective + 1e-9);
        EXPECT_GE(value.upper, objective - 1e-9);
        EXPECT_LE(value.upper - value.lower, surface.error * std::max(1.0, value.upper));
    }
}

TEST(TradeOffSurface, HoldsForRandomWeights) {
    const Scene scene = paper_objective(MotionType::drd, 3, 32);
    const double error = 1.0 / scenes_to_try(1000, 10000);
    const TradeOffSurface surface = trade_off_surface(scene, {error});
    EXPECT_EQ(surface.end, SurfaceEnd::reached);
    EXPECT_LE(surface.error, error);
    EXPECT_LE(surface.table.rows.size(), 310U);
    expect_it_holds(scene, surface, scenes_to_try(60, 2000));
}

TEST(TradeOffSurface, HoldsWhereLimitIsActive) {
    Scene scene = paper_objective(MotionType::drd, 3, 12);
    scene.limits.velocity = normalised_limit("limits.velocity", 1.7);
    const TradeOffSurface surface = trade_off_surface(scene, {1e-3});
    EXPECT_EQ(surface.end, SurfaceEnd::reached);
    expect_it_holds(scene, surface, 40);
}

TEST(TradeOffSurface, ResumesWhereItStopped) {
    const Scene scene = paper_objective(MotionType::drd, 3, 12);
    const TradeOffSurface whole = trade_off_surface(scene, {1e-4});
    const TradeOffSurface part = trade_off_surface(scene, {1e-4, 20});
    EXPECT_EQ(part.end, SurfaceEnd::solves);
    EXPECT_EQ(part.table.rows.size(), 20U);
    EXPECT_GT(part.error, whole.error);
    int solved = 0;
    const TradeOffSurface rest = trade_off_surface(
        scene, {1e-4}, {.known = part.table.rows, .found = [&](const auto&...) { ++solved; }});
    EXPECT_EQ(rest.end, SurfaceEnd::reached);
    ASSERT_EQ(rest.table.rows.size(), whole.table.rows.size());
    EXPECT_EQ(solved, static_cast<int>(whole.table.rows.size()) - 20);
    for (std::size_t k = 0; k < 20; ++k)
        EXPECT_EQ(rest.table.rows[k].settings, whole.table.rows[k].settings) << k;
}

TEST(TradeOffSurface, ReportsItsCoverageWhenStopped) {
    const Scene scene = paper_objective(MotionType::drd, 3, 12);
    int polls = 0;
    SolveControl control;
    control.stop_requested = [&] { return ++polls > 200; };
    const TradeOffSurface surface = trade_off_surface(scene, {1e-5}, {.control = control});
    EXPECT_EQ(surface.end, SurfaceEnd::interrupted);
    ASSERT_TRUE(surface.hull);
    EXPECT_GT(surface.error, 1e-5);
    expect_it_holds(scene, surface, 20);
}

TEST(TradeOffSurface, ClaimsOnlyWhatItSolved) {
    // Bounds far below the objectives: solves as of a scene that nobody can prove.
    const Scene scene = paper_objective(MotionType::drd, 3, 12);
    std::vector<SweepRow> loose = trade_off_surface(scene, {0.5, 3}).table.rows;
    ASSERT_EQ(loose.size(), 3U);
    const double proved = trade_off_surface(scene, {1e-2, 3}, {.known = loose}).error;
    for (SweepRow& row : loose) *row.lower_bound -= 0.05;
    const TradeOffSurface surface = trade_off_surface(scene, {1e-2, 3}, {.known = loose});
    EXPECT_NEAR(surface.error, proved + 0.05, 0.01);
    EXPECT_EQ(surface.end, SurfaceEnd::solves);
}

TEST(TradeOffSurface, AnInfeasibleSceneHasNone) {
    Scene scene = paper_objective(MotionType::drd, 3, 8);
    scene.limits.velocity = normalised_limit("limits.velocity", 1.0);
    const TradeOffSurface surface = trade_off_surface(scene, {1e-3});
    EXPECT_EQ(surface.end, SurfaceEnd::no_motion);
    EXPECT_FALSE(surface.hull);
    ASSERT_EQ(surface.table.rows.size(), 1U);
    EXPECT_EQ(surface.table.rows[0].verdict, Verdict::infeasible);
    EXPECT_THROW((void)surface.at({0.4, 0.4, 0.2}), InputError);
}

TEST(TradeOffSurface, RefusesUnusableGoals) {
    Scene scene = paper_objective(MotionType::drd, 3, 8);
    EXPECT_THROW((void)trade_off_surface(scene, {0.0}), InputError);
    EXPECT_THROW((void)trade_off_surface(scene, {1e-3, 2}), InputError);
    scene.objective.rms_jerk = 0.1;
    const std::string said = refusal([&] { (void)trade_off_surface(scene, {1e-3}); });
    EXPECT_NE(said.find("objective.rms_jerk"), std::string::npos) << said;
}

TEST(WeightHull, IsConcaveAndHoldsEveryHeight) {
    std::mt19937 random(9);
    WeightHull hull({0.0, 0.0, 0.0});
    const auto bowl = [](const Eigen::Vector3d& w) { return 1.0 - w.squaredNorm(); };
    std::vector<Eigen::Vector3d> places;
    for (int k = 0; k < 200; ++k) {
        const PeakTriple weights = random_weights(random);
        places.emplace_back(weights[0], weights[1], weights[2]);
        hull.add(places.back(), bowl(places.back()));
    }
    for (const Eigen::Vector3d& place : places) EXPECT_NEAR(hull.at(place), bowl(place), 1e-12);
    // Euler: without points inside edges, each inner point adds two triangles.
    EXPECT_EQ(hull.triangles().size(), 1U + 2U * 200U);
    double area = 0.0;
    for (const HullTriangle& triangle : hull.triangles()) {
        Eigen::Matrix3d corners;
        for (int k = 0; k < 3; ++k)
            corners.row(k) = hull.weights(triangle.corners[static_cast<std::size_t>(k)]);
        area += std::abs(corners.determinant());
    }
    EXPECT_NEAR(area, 1.0, 1e-9);
    EXPECT_LE(hull.at({0.2, 0.3, 0.5}), bowl({0.2, 0.3, 0.5}) + 1e-12);
}

}  // namespace trade_off_surface_test
}  // namespace camopt
