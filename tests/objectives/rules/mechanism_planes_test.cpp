// SPDX-License-Identifier: MIT
// Planes under the limits of every kind of mechanism over random boxes: never above the limit, and nearer the
// smaller the box. Which rules have none.
#include "core/units.hpp"
#include "objectives/own_point_rule.hpp"
#include "objectives/scene_model.hpp"
#include "profiles/inverse/inverse_mechanism.hpp"
#include "profiles/inverse/inverse_spec.hpp"
#include "profiles/remote/remote_cam.hpp"
#include "profiles/spatial/spatial_cam.hpp"
#include "tests/objectives/rules/plane_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace camopt {
namespace mechanism_planes_test {

using units::degree, units::millimetre, units::inch;

struct Case {
    std::string name;
    CamSpec spec;
    double lift = 0.0;
    std::shared_ptr<const CamMechanism> formulas;
    double at = 0.0;  ///< x
};
void PrintTo(const Case& which, std::ostream* stream) {
    *stream << which.name;
}

template <class Number>
Dimension& number_of(CamSpec& spec, Number which) {
    return spec.dimensions[static_cast<std::size_t>(which)].value;
}

/// Of its number's size.
template <class Number>
void set_free(CamSpec& spec, Number which) {
    Dimension& own = number_of(spec, which);
    const double middle = own.low, part = 0.05 * std::abs(middle);
    own = Dimension(middle - part, middle + part);
}

using Spatial = std::vector<std::pair<SpatialNumber, double>>;
CamSpec spatial(SpatialFollower follower, Rotation rotation, const Spatial& numbers,
                const std::vector<SpatialNumber>& free) {
    CamSpec spec = spatial_spec(follower);
    spec.rotation = rotation;
    for (const auto& [which, value] : numbers) number_of(spec, which) = Dimension(value);
    for (const SpatialNumber which : free) set_free(spec, which);
    return spec;
}

CamSpec barrel(Rotation rotation, const std::vector<SpatialNumber>& free) {
    using enum SpatialNumber;
    return spatial(SpatialFollower::barrel, rotation,
                   {{roller_radius, 0.03},
                    {arm_length, 0.16},
                    {center_distance, 0.15},
                    {lateral_offset, 0.155},
                    {roller_length, 0.04},
                    {start, -25 * degree}},
                   free);
}

CamSpec wheel(Rotation rotation, const std::vector<SpatialNumber>& free) {
    using enum SpatialNumber;
    return spatial(SpatialFollower::cylindrical_rotating, rotation,
                   {{roller_radius, 0.008},
                    {arm_length, 0.07},
                    {center_distance, 0.15},
                    {lateral_offset, 0.01},
                    {roller_length, 0.02},
                    {start, -22.5 * degree}},
                   free);
}

CamSpec slide(const std::vector<SpatialNumber>& free) {
    using enum SpatialNumber;
    return spatial(
        SpatialFollower::cylindrical_translating, Rotation::clockwise,
        {{roller_radius, 0.01}, {center_distance, 0.06}, {lateral_offset, 0.01}, {roller_length, 0.015}},
        free);
}

CamSpec remote(RemoteLinkage linkage, PressurePoint point, const std::vector<RemoteDimension>& free) {
    using enum RemoteDimension;
    CamSpec spec = remote_spec(linkage);
    spec.choices["pressure_angle_at"] = name_of(point);
    if (linkage != RemoteLinkage::lever) spec.choices["lever_branch"] = "right";
    std::vector<std::pair<RemoteDimension, double>> numbers = {
        {roller_radius, 30}, {roller_arm, 160}, {lever_pivot_x, -160}, {lever_pivot_y, 85}};
    const bool rocks = linkage == RemoteLinkage::lever_coupler_lever ||
                       linkage == RemoteLinkage::lever_coupler_lever_coupler_slider;
    if (linkage != RemoteLinkage::lever)
        numbers.insert(numbers.end(), {{lever_arm, 240}, {coupler, 351.3}, {lever_angle, -10}});
    if (rocks)
        numbers.insert(numbers.end(),
                       {{rocker_pivot_x, 260}, {rocker_pivot_y, 400}, {rocker_input_arm, 220}});
    if (linkage == RemoteLinkage::lever_coupler_slider)
        numbers.insert(numbers.end(), {{slider_x, 43}, {slider_y, 360}, {slider_angle, 90}});
    if (linkage == RemoteLinkage::lever_coupler_lever_coupler_slider)
        numbers.insert(numbers.end(), {{rocker_output_arm, 250},
                                       {second_coupler, 200},
                                       {slider_x, 10},
                                       {slider_y, 560},
                                       {slider_angle, 90}});
    if (linkage == RemoteLinkage::lever) numbers.emplace_back(output_angle, 5);
    if (linkage == RemoteLinkage::lever_coupler_lever) numbers.emplace_back(output_angle, 172);
    for (const auto& [which, value] : numbers)
        number_of(spec, which) = Dimension(value * (is_angle(which) ? degree : millimetre));
    for (const RemoteDimension which : free) set_free(spec, which);
    return spec;
}

CamSpec inverse(const std::vector<InverseNumber>& free) {
    using enum InverseNumber;
    CamSpec spec = inverse_spec();
    const std::pair<InverseNumber, double> lengths[] = {
        {roller_radius, 0.5},      {roller_rest, 1.5},   {roller_end, 13.982},
        {roller_from, 3.0},        {pin_distance, 15.0}, {rocker_pivot_x, 18.3756},
        {rocker_pivot_y, 0.93306}, {feeder_offset, 4.0}, {feeder_start, -0.655}};
    for (const auto& [which, value] : lengths) number_of(spec, which) = Dimension(value * inch);
    number_of(spec, pin_angle) = Dimension(9 * degree);
    number_of(spec, roller_angle) = Dimension(220 * degree);
    for (const InverseNumber which : free) set_free(spec, which);
    return spec;
}

std::vector<Case> cases() {
    constexpr auto back = Rotation::clockwise, on = Rotation::counterclockwise;
    std::vector<Case> all;
    const auto add_spatial = [&](const char* name, const CamSpec& spec, double lift) {
        all.push_back({name, spec, lift, spatial_mechanism(spec)});
    };
    add_spatial("barrel", barrel(on, {}), 50 * degree);
    add_spatial("barrel clockwise", barrel(back, {}), 50 * degree);
    using Of = SpatialNumber;
    add_spatial("barrel, free", barrel(back, {Of::center_distance, Of::arm_length, Of::roller_length}),
                50 * degree);
    add_spatial("wheel", wheel(on, {}), 45 * degree);
    add_spatial("wheel clockwise, free",
                wheel(back, {Of::center_distance, Of::lateral_offset, Of::roller_radius}), 45 * degree);
    add_spatial("slide", slide({}), 40 * millimetre);
    add_spatial("slide, free", slide({Of::center_distance, Of::roller_radius}), 40 * millimetre);
    const auto add_remote = [&](const char* name, const CamSpec& spec, double lift) {
        all.push_back({name, spec, lift, std::make_shared<RemoteCam>(spec)});
    };
    using enum RemoteLinkage;
    using enum PressurePoint;
    using enum RemoteDimension;
    add_remote("lever", remote(lever, roller_center, {}), 20 * degree);
    add_remote("lever, at the contact, free", remote(lever, contact_point, {roller_arm}), 20 * degree);
    add_remote("one dyad to a slider, free",
               remote(lever_coupler_slider, roller_center, {coupler, lever_arm}), 30 * millimetre);
    add_remote("one dyad to a rocker", remote(lever_coupler_lever, roller_center, {}), 20 * degree);
    add_remote("one dyad to a rocker, at the contact", remote(lever_coupler_lever, contact_point, {}),
               20 * degree);
    add_remote("two dyads", remote(lever_coupler_lever_coupler_slider, roller_center, {}), 80 * millimetre);
    add_remote("two dyads, free",
               remote(lever_coupler_lever_coupler_slider, roller_center, {lever_pivot_y, rocker_input_arm}),
               80 * millimetre);
    const auto add_inverse = [&](const char* name, const CamSpec& spec, double at) {
        all.push_back({name, spec, 2.694 * inch, inverse_mechanism(spec), at});
    };
    add_inverse("inverse, early", inverse({}), 0.2);
    add_inverse("inverse, late", inverse({}), 0.9);
    add_inverse("inverse, free", inverse({InverseNumber::roller_radius, InverseNumber::pin_distance}), 0.5);
    return all;
}

Scene scene_of(const Case& which) {
    Scene scene;
    scene.motion.lift = which.lift;
    scene.motion.lift_is_angle = which.formulas->swings();
    scene.motion.rise = 150 * degree;
    scene.objective.jerk = 1.0;
    scene.cam = which.spec;
    scene.cam->make = [formulas = which.formulas](const CamSpec&) { return formulas; };
    scene.limits.pressure_angle = WrittenLimit{30 * degree, "limits.pressure_angle_deg", degree, "deg"};
    scene.limits.undercut_margin = WrittenLimit{0.3, "limits.undercut_margin", 1.0, ""};
    if (which.formulas->radius_quantity()) {
        scene.limits.cam_radius_min = WrittenLimit{0.01, "limits.cam_radius_min_mm", millimetre, "mm"};
        scene.limits.concave_radius_min =
            WrittenLimit{0.06, "limits.concave_radius_min_mm", millimetre, "mm"};
    }
    return scene;
}

class MechanismPlanes : public testing::TestWithParam<Case> {};

TEST_P(MechanismPlanes, AreNeverAboveTheRule) {
    const Scene scene = scene_of(GetParam());
    ASSERT_FALSE(find_fault(scene)) << find_fault(scene)->found;
    const CamModel model = scene_model(scene, DesignKind::states, reference_peaks(scene));
    unsigned seed = 31;
    int rules = 0;
    for (const PlacedRule& rule : model.rules) {
        if (!rule->limit()) continue;
        ++rules;
        const auto place = [&](std::mt19937& random) {
            const auto between = [&](double low, double high) {
                return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
            };
            Eigen::VectorXd z(4 + static_cast<Eigen::Index>(rule->parameters().size()));
            z.head<4>() << between(0.02, 0.98), between(-2.0, 2.0), between(-6.0, 6.0), between(-20.0, 20.0);
            for (Eigen::Index k = 4; k < z.size(); ++k) {
                const Parameter& own = model.parameters[static_cast<std::size_t>(
                    rule->parameters()[static_cast<std::size_t>(k - 4)])];
                z[k] = between(own.lower, own.upper);
            }
            return z;
        };
        const int planes = testing_support::check_planes(*rule, place, ++seed, GetParam().at);
        EXPECT_GE(planes, testing_support::scenes_to_try(500, 5000)) << rule->origin().text();
    }
    EXPECT_GE(rules, 3);
}

/// A polynomial about x0: values of y to its fourth derivative.
std::array<double, 5> derivatives_at(const std::array<double, 5>& taylor, double t) {
    const double a = taylor[1], b = taylor[2], c = taylor[3], d = taylor[4];
    return {taylor[0] + t * (a + t * (b + t * (c + t * d))), a + t * (2 * b + t * (3 * c + t * 4 * d)),
            2 * b + t * (6 * c + t * 12 * d), 6 * c + 24 * t * d, 24 * d};
}

/// Along random stretches of random motions: every value, slope and second derivative lies in what encloses
/// it; and of a stretch without length the enclosure is the value itself.
TEST_P(MechanismPlanes, StretchesAreEnclosed) {
    const Scene scene = scene_of(GetParam());
    const CamModel model = scene_model(scene, DesignKind::states, reference_peaks(scene));
    std::mt19937 random(17);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
    };
    constexpr double half = 1e-3, step = 1e-4;
    int looked = 0;
    for (const PlacedRule& rule : model.rules) {
        if (!rule->limit()) continue;
        Eigen::VectorXd q(static_cast<Eigen::Index>(rule->parameters().size()));
        for (int trial = 0; trial < 30; ++trial) {
            for (Eigen::Index k = 0; k < q.size(); ++k) {
                const Parameter& own = model.parameters[static_cast<std::size_t>(
                    rule->parameters()[static_cast<std::size_t>(k)])];
                q[k] = between(own.lower, own.upper);
            }
            const double x0 = between(0.1, 0.9);
            const std::array<double, 5> taylor = {between(0.05, 0.95), between(-2.0, 2.0), between(-3.0, 3.0),
                                                  between(-3.0, 3.0), between(-3.0, 3.0)};
            const auto value = [&](double t) {
                const auto y = derivatives_at(taylor, t);
                return rule->evaluate({x0 + t, {y[0], y[1], y[2], y[3]}}, q).value;
            };
            const auto over = [&](double width) {
                std::array<Interval, 5> ranges;
                for (std::size_t r = 0; r < ranges.size(); ++r) {
                    ranges[r] = derivatives_at(taylor, -width)[r];
                    for (int k = 0; k <= 100; ++k) {
                        const double y = derivatives_at(taylor, width * (k / 50.0 - 1.0))[r];
                        ranges[r] = {std::min(ranges[r].lower, y), std::max(ranges[r].upper, y)};
                    }
                }
                return rule->range_along({x0 - width, x0 + width}, ranges, q);
            };
            if (!std::isfinite(value(0.0))) continue;
            const auto range = over(half), place = over(0.0);
            ASSERT_TRUE(range && place) << rule->origin().text();
            if (!std::isfinite(range->bend.lower) || !std::isfinite(range->bend.upper)) continue;
            ++looked;
            const double size = 1.0 + std::abs(value(0.0));
            EXPECT_LT(place->value.width(), 1e-9 * size) << rule->origin().text();
            EXPECT_TRUE(place->value.holds(value(0.0)) ||
                        std::abs(value(0.0) - place->value.lower) < 1e-11 * size)
                << rule->origin().text();
            for (const double t : {-half + step, 0.0, half - step}) {
                const double slope = (value(t + step) - value(t - step)) / (2.0 * step);
                const double bend = (value(t + step) - 2.0 * value(t) + value(t - step)) / (step * step);
                const double rough = 1e-4 * (1.0 + std::abs(slope) + std::abs(bend));
                EXPECT_LE(range->value.lower - 1e-11 * size, value(t)) << rule->origin().text();
                EXPECT_GE(range->value.upper + 1e-11 * size, value(t)) << rule->origin().text();
                EXPECT_LE(range->slope.lower - rough, slope) << rule->origin().text();
                EXPECT_GE(range->slope.upper + rough, slope) << rule->origin().text();
                EXPECT_LE(range->bend.lower - rough, bend) << rule->origin().text();
                EXPECT_GE(range->bend.upper + rough, bend) << rule->origin().text();
            }
        }
    }
    EXPECT_GE(looked, 50);
}

INSTANTIATE_TEST_SUITE_P(EveryKind, MechanismPlanes, testing::ValuesIn(cases()));

/// What looks at the whole motion, and a formula of the program that embeds, have no enclosure and say so.
TEST(RulesWithoutPlanes, SaySo) {
    OwnLimit own{};
    own.name = "own";
    own.limit = 1.0;
    own.formula = motion_formula([](const auto&, const auto& v, const auto&, const auto&) { return v * v; });
    const OwnPointRule rule(own);
    EXPECT_FALSE(rule.range_over(std::vector<Interval>(4, Interval(0.5)), 0.0));
    EXPECT_FALSE(RuleOverBox::make(rule, std::vector<Interval>(4, Interval(0.4, 0.5)), 0.0));
}

}  // namespace mechanism_planes_test
}  // namespace camopt
