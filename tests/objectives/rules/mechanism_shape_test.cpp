// SPDX-License-Identifier: MIT
// Which limits of a mechanism are linear or convex, held against the formulas themselves: chords, and where
// the rule is continued.
#include "core/units.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "objectives/scene_model.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace camopt {
namespace mechanism_shape_test {

using namespace testing_support;
using units::degree;
constexpr double limit = 40 * degree;

Scene barrel(const char* rotation, const char* distance = "cam.center_distance_mm = 150") {
    return scene_named("barrel_index").set("cam.rotation", rotation).with(distance);
}

std::vector<PlacedRule> limits_of(const Scene& scene) {
    std::vector<PlacedRule> rules;
    for (const PlacedRule& rule : scene_model(scene, DesignKind::states, reference_peaks(scene)).rules)
        if (rule->limit()) rules.push_back(rule);
    return rules;
}

/// A point of the motion and the parameters in one vector: y, y', y'', y'''; q.
Eigen::VectorXd random_place(std::mt19937& generator, Eigen::Index parameters) {
    // Far outside of the lift too: the index is turned by up to ±175 deg.
    std::uniform_real_distribution<double> displacement(-3.0, 4.0), slope(-8.0, 8.0), part(0.7, 1.0);
    Eigen::VectorXd place = Eigen::VectorXd::Zero(4 + parameters);
    place[0] = displacement(generator);
    place[1] = slope(generator);
    for (Eigen::Index k = 0; k < parameters; ++k) place[4 + k] = part(generator);
    return place;
}

RuleValue at(const PlacedRule& rule, const Eigen::VectorXd& place) {
    return rule->evaluate({0.0, {place[0], place[1], place[2], place[3]}}, place.tail(place.size() - 4));
}

void expect_shape(const Scene& scene, Curvature shape) {
    ASSERT_FALSE(find_fault(scene)) << find_fault(scene)->found;
    std::mt19937 generator(11);
    const std::vector<PlacedRule> rules = limits_of(scene);
    EXPECT_EQ(rules.size(), 4U);
    for (const PlacedRule& rule : rules) {
        EXPECT_EQ(rule->curvature(-infinity, infinity), shape);
        EXPECT_EQ(rule->linear(), shape == Curvature::linear);
        const auto parameters = static_cast<Eigen::Index>(rule->parameters().size());
        for (int trial = 0; trial < 500 && shape != Curvature::general; ++trial) {
            const Eigen::VectorXd a = random_place(generator, parameters),
                                  b = random_place(generator, parameters);
            const double middle = at(rule, 0.5 * (a + b)).value;
            const double chord = 0.5 * (at(rule, a).value + at(rule, b).value);
            EXPECT_LE(middle, chord + 1e-13);
            EXPECT_TRUE(shape != Curvature::linear || std::abs(middle - chord) < 1e-13);
        }
    }
}

TEST(MechanismShape, BarrelsOfFixedSizeAreConvex) {
    expect_shape(barrel("counterclockwise"), Curvature::convex);
    expect_shape(barrel("clockwise"), Curvature::convex);
}

TEST(MechanismShape, SlidesAreLinearWithAnyRadius) {
    expect_shape(scene_named("slide_of_any_radius"), Curvature::linear);
}

TEST(MechanismShape, TheOthersClaimNothing) {
    expect_shape(barrel("clockwise", "cam.center_distance_mm = { min = 140, max = 170 }"),
                 Curvature::general);
    expect_shape(
        scene_named("ocrf_indexing").with("limits = { pressure_angle_deg = 40 }", "motion.rise_deg = 160"),
        Curvature::general);
}

/// Where the index is within the limit of the line through both axes, the rule is the pressure angle's;
/// beyond, it is never more generous, and its partials are the differences across the joint.
TEST(MechanismShape, BarrelRuleIsExtendedConservatively) {
    for (const char* rotation : {"counterclockwise", "clockwise"}) {
        const Scene scene = barrel(rotation);
        const std::vector<double> numbers = scene.cam->middle();
        const std::vector<PlacedRule> rules = limits_of(scene);
        std::mt19937 generator(12);
        int within = 0, beyond = 0;
        for (int trial = 0; trial < 2000; ++trial) {
            const Eigen::VectorXd place = random_place(generator, 0);
            const double angle = -25 * degree + 50 * degree * place[0];
            double worst = -infinity;
            for (const PlacedRule& rule : rules) worst = std::max(worst, at(rule, place).value);
            double largest = 0.0;
            for (int station = 0; station < scene.cam->formulas()->stations(); ++station) {
                const FollowerState state{50 * degree * place[0], 50.0 / 160.0 * place[1], 0.0};
                const MechanismPoint point = scene.cam->formulas()->point(0.0, {numbers, state}, station);
                largest = std::max(largest, std::abs(point.pressure_angle));
            }
            const bool kept = largest <= limit && std::abs(angle) < 90 * degree;
            if (std::abs(angle) <= limit) {
                ++within;
                EXPECT_EQ(worst <= 0.0, kept) << angle / degree << " deg, slope " << place[1];
            } else {
                beyond += worst <= 0.0 ? 0 : 1;
                EXPECT_FALSE(worst <= 0.0 && !kept) << angle / degree << " deg, slope " << place[1];
            }
        }
        EXPECT_GT(within, 300);
        EXPECT_GT(beyond, 300);
    }
}

TEST(MechanismShape, ContinuationPartialsMatchDifferences) {
    constexpr double step = 1e-5;
    for (const PlacedRule& rule : limits_of(barrel("clockwise")))
        for (const double displacement : {-2.5, -0.7, -0.35, 0.4, 1.35, 1.7, 3.5}) {
            Eigen::VectorXd place(4);
            place << displacement, 1.3, 0.0, 0.0;
            const RuleValue exact = at(rule, place);
            Eigen::VectorXd left = place, right = place;
            left[0] -= step;
            right[0] += step;
            const RuleValue before = at(rule, left), after = at(rule, right);
            EXPECT_NEAR(exact.gradient[0], (after.value - before.value) / (2 * step), 1e-8);
            EXPECT_NEAR(exact.hessian(0, 0), (after.gradient[0] - before.gradient[0]) / (2 * step), 1e-8);
        }
}

}  // namespace mechanism_shape_test
}  // namespace camopt
