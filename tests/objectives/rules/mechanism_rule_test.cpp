// SPDX-License-Identifier: MIT
// Limits of a mechanism as rules: exactly the rows asked for, kept just where the point of the cam keeps the
// limit, partials in the optimizer's own variables against differences.
#include "core/units.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "objectives/scene_model.hpp"
#include "profiles/remote/remote_cam.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

namespace camopt {
namespace mechanism_rule_test {

using units::degree, units::millimetre;

/// A lever that a coupler joins to a slider; its angles of the pressure lie around 30 deg.
Scene scene() {
    return testing_support::scene_named("lever_coupler_slider").with("objective = { jerk = 1 }");
}

WrittenLimit limit(const char* key, double value) {
    return {value, key, 1.0, ""};
}

std::vector<std::string> limits_of(const CamModel& model) {
    std::vector<std::string> names;
    for (const PlacedRule& rule : model.rules)
        if (rule->limit()) names.push_back(rule->name());
    return names;
}

MotionPoint random_point(std::mt19937& generator) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(generator);
    };
    return {0.0, {between(0.0, 1.0), between(-8.0, 8.0), between(-40.0, 40.0), 0.0}};
}

TEST(MechanismRule, TheSceneIsSound) {
    EXPECT_FALSE(find_fault(scene()).has_value()) << find_fault(scene())->found;
}

TEST(MechanismRule, ContainsOnlyRequestedRows) {
    Scene own = scene();
    const Peaks reference = reference_peaks(own);
    EXPECT_TRUE(limits_of(scene_model(own, DesignKind::states, reference)).empty());
    own.limits.pressure_angle = limit("limits.pressure_angle_deg", 30 * degree);
    using Names = std::vector<std::string>;
    EXPECT_EQ(limits_of(scene_model(own, DesignKind::states, reference)),
              (Names{"limits.pressure_angle_deg", "limits.pressure_angle_deg"}));
    own.limits.pressure_angle.reset();
    own.limits.cam_radius_min = limit("limits.cam_radius_min_mm", 0.0);
    own.limits.concave_radius_min = limit("limits.concave_radius_min_mm", 0.1);
    own.limits.undercut_margin = limit("limits.undercut_margin", 0.1);
    EXPECT_EQ(limits_of(scene_model(own, DesignKind::states, reference)),
              (Names{"limits.cam_radius_min_mm", "limits.concave_radius_min_mm", "limits.undercut_margin"}));
    // The roller of 15 mm fits into any hollow larger than it by itself.
    own.limits.concave_radius_min = limit("limits.concave_radius_min_mm", 0.01);
    EXPECT_EQ(limits_of(scene_model(own, DesignKind::states, reference)).size(), 2u);
}

TEST(MechanismRule, SatisfiedExactlyWhenLimitIs) {
    Scene own = scene();
    own.limits.pressure_angle = limit("limits.pressure_angle_deg", 30 * degree);
    own.limits.cam_radius_min = limit("limits.cam_radius_min_mm", 0.01);
    own.limits.concave_radius_min = limit("limits.concave_radius_min_mm", 0.06);
    own.limits.undercut_margin = limit("limits.undercut_margin", 0.5);
    const CamModel model = scene_model(own, DesignKind::states, reference_peaks(own));
    const std::vector<double> numbers = own.cam->middle();
    std::mt19937 generator(7);
    std::map<std::string, std::array<int, 2>> seen;
    for (int trial = 0; trial < 2000; ++trial) {
        const MotionPoint motion = random_point(generator);
        const FollowerState state = state_of(motion, model.cam->scale);
        const MechanismPoint point = own.cam->formulas()->point(0.0, {numbers, state}, 0);
        std::map<std::string, bool> kept;
        for (const PlacedRule& rule : model.rules) {
            if (!rule->limit()) continue;
            const bool own_kept = rule->evaluate(motion, {}).value <= 0.0;
            const auto [place, fresh] = kept.try_emplace(rule->name(), own_kept);
            if (!fresh) place->second = place->second && own_kept;
        }
        const double curvature = point.pitch_curvature;
        const std::map<std::string, bool> expected = {
            {"limits.pressure_angle_deg", std::abs(point.pressure_angle) <= 30 * degree},
            {"limits.cam_radius_min_mm", curvature <= 0.0 || 1.0 / curvature - 0.015 >= 0.01},
            {"limits.concave_radius_min_mm", curvature >= 0.0 || 0.015 - 1.0 / curvature >= 0.06},
            {"limits.undercut_margin", point.regularity >= 0.5}};
        EXPECT_EQ(kept, expected);
        for (const auto& [name, own_kept] : kept) ++seen[name][own_kept ? 1 : 0];
    }
    for (const auto& [name, count] : seen) {
        EXPECT_GT(count[0], 20) << name << " is never broken: nothing was tested";
        EXPECT_GT(count[1], 20) << name;
    }
}

TEST(MechanismRule, PartialsAreTheDifferences) {
    Scene own = scene();
    own.limits.pressure_angle = limit("limits.pressure_angle_deg", 30 * degree);
    own.limits.cam_radius_min = limit("limits.cam_radius_min_mm", 0.01);
    own.limits.undercut_margin = limit("limits.undercut_margin", 0.5);
    const auto free = [&](RemoteDimension which, double low, double high) {
        own.cam->dimensions[static_cast<std::size_t>(which)].value =
            Dimension(low * millimetre, high * millimetre);
    };
    free(RemoteDimension::roller_radius, 10, 20);
    free(RemoteDimension::center_y, -15, -5);
    free(RemoteDimension::coupler, 195, 205);
    const CamModel model = scene_model(own, DesignKind::states, reference_peaks(own));
    std::mt19937 generator(8);
    int rules = 0;
    for (const PlacedRule& rule : model.rules) {
        if (!rule->limit()) continue;
        ++rules;
        ASSERT_EQ(rule->parameters().size(), 3u);
        const MotionPoint motion = random_point(generator);
        Eigen::VectorXd q(3);
        for (int k = 0; k < 3; ++k) {
            const Parameter& parameter = model.parameters[static_cast<std::size_t>(rule->parameters()[k])];
            q[k] = 0.5 * (parameter.lower + parameter.upper);
        }
        const RuleValue exact = rule->evaluate(motion, q);
        const auto moved = [&](int variable, double step) {
            MotionPoint point = motion;
            Eigen::VectorXd other = q;
            (variable < 4 ? point.derivative[static_cast<std::size_t>(variable)] : other[variable - 4]) +=
                step;
            return rule->evaluate(point, other);
        };
        for (int v = 0; v < 7; ++v) {
            const double h = 1e-4;
            const RuleValue up = moved(v, h), down = moved(v, -h), up2 = moved(v, 2 * h),
                            down2 = moved(v, -2 * h);
            const double first = (8 * (up.value - down.value) - (up2.value - down2.value)) / (12 * h);
            EXPECT_NEAR(exact.gradient[v], first, 1e-8 * (1.0 + exact.gradient.norm())) << rule->name() << v;
            const Eigen::VectorXd second =
                (8 * (up.gradient - down.gradient) - (up2.gradient - down2.gradient)) / (12 * h);
            EXPECT_LT((exact.hessian.col(v) - second).norm(), 1e-7 * (1.0 + exact.hessian.norm()))
                << rule->name() << v;
        }
    }
    EXPECT_EQ(rules, 4);
}

}  // namespace mechanism_rule_test
}  // namespace camopt
