// SPDX-License-Identifier: MIT
// One generic test for every limit of a cam: partials, and the shape (linear, convex) it claims.
#include "core/units.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "tests/objectives/rules/plane_check.hpp"
#include "tests/support/middle_cam.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {
namespace cam_rules_test {

using enum DimensionIndex;

struct Case {
    FollowerType follower;
    Rotation rotation;
    bool variable;  ///< every dimension is a variable
    CamForm form = CamForm::open;
};
void PrintTo(const Case& which, std::ostream* stream) {
    *stream << name_of(which.follower) << ' ' << name_of(which.rotation) << ' ' << name_of(which.form);
}

double uniform(std::mt19937& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
}

WrittenLimit limit(double value, const char* key) {
    return {value, key, 1.0, ""};
}

Scene scene_of(const Case& which) {
    Scene scene;
    const bool swings = is_oscillating(which.follower);
    scene.motion.lift = swings ? 15.0 * units::degree : 20e-3;
    scene.motion.lift_is_angle = swings;
    scene.motion.rise = 90.0 * units::degree;
    scene.motion.speed = 30.0;
    scene.cam = disk_spec({.follower = which.follower});
    scene.cam->rotation = which.rotation;
    const auto set = [&](DimensionIndex dimension, double value) {
        if (!has_dimension(which.follower, dimension)) return;
        scene.cam->set(dimension, which.variable ? Dimension(0.9 * value, 1.1 * value) : Dimension(value));
    };
    set(base_radius, swings ? 60e-3 : 40e-3);
    set(roller_radius, 10e-3);
    set(offset, 5e-3);
    set(center_distance, 100e-3);
    set(arm_length, 80e-3);
    set(face_offset, 4e-3);
    if (which.follower == FollowerType::translating_flat) scene.cam->face_half_width = 25e-3;
    scene.forces = ForceSpec{.mass = 0.5, .spring_rate = 3000.0, .preload = 200.0, .contact_width = 10e-3};
    LimitSpec& limits = scene.limits;
    limits.rise_pressure_angle = limit(0.5, "limits.rise_pressure_angle_rad");
    limits.return_pressure_angle = limit(0.6, "limits.return_pressure_angle_rad");
    limits.cam_radius_min = limit(6e-3, "limits.cam_radius_min_m");
    if (!has_flat_face(which.follower))
        limits.concave_radius_min = limit(40e-3, "limits.concave_radius_min_m");
    limits.undercut_margin = limit(0.2, "limits.undercut_margin");
    if (which.form == CamForm::open) limits.contact_force_min = limit(10.0, "limits.contact_force_min_n");
    DiskSpec disk = disk_of(*scene.cam);
    FormSpec& form = disk.form;
    form.type = which.form;
    if (which.form == CamForm::grooved) form.groove_clearance = 0.2e-3;
    if (which.form == CamForm::conjugate) {
        if (swings)
            form.arm_angle = 80.0 * units::degree;
        else
            form.roller_distance = 125e-3;
        form.second_roller_radius = 9e-3;
        scene.forces->preload = -20.0;  // both disks carry
    }
    scene.cam = disk_spec(disk);
    limits.torque_max = limit(15.0, "limits.torque_max_nm");
    if (which.follower != FollowerType::translating_knife)
        limits.hertz_pressure_max = limit(8e8, "limits.hertz_pressure_max_pa");
    return scene;
}

std::shared_ptr<const CamVariables> variables_of(const Scene& scene) {
    auto cam = std::make_shared<CamVariables>();
    cam->cam = disk_mechanism(middle_cam(disk_of(*scene.cam)));
    cam->scale = {scene.motion.lift, scene.motion.unit_angle()};
    int parameter = 0;
    const std::vector<CamDimension>& all = scene.cam->dimensions;
    for (std::size_t d = 0; d < all.size(); ++d)
        if (all[d].value.is_variable())
            cam->variables.push_back({static_cast<int>(d), parameter++, all[d].value.high});
    return cam;
}

/// (y, y', y'', y''', q) at random, near a motion that a cam follows.
Eigen::VectorXd random_place(const CamVariables& cam, std::mt19937& random) {
    const auto dimensions = static_cast<Eigen::Index>(cam.variables.size());
    Eigen::VectorXd place(4 + dimensions);
    place.head<4>() << uniform(random, 0.0, 1.0), uniform(random, -1.2, 1.2), uniform(random, -3.0, 3.0),
        uniform(random, -20.0, 20.0);
    for (Eigen::Index k = 0; k < dimensions; ++k) {
        const CamVariables::Variable& variable = cam.variables[static_cast<std::size_t>(k)];
        place[4 + k] = cam.cam.dimensions[static_cast<std::size_t>(variable.dimension)] / variable.reference *
                       uniform(random, 0.96, 1.04);
    }
    return place;
}

RuleValue at(const CamRule& rule, const Eigen::VectorXd& place) {
    return rule.evaluate({0.0, {place[0], place[1], place[2], place[3]}}, place.tail(place.size() - 4));
}

class CamRules : public testing::TestWithParam<Case> {};

TEST_P(CamRules, BoxPlanesAreLowerBounds) {
    const Scene scene = scene_of(GetParam());
    const auto cam = variables_of(scene);
    unsigned seed = 11;
    for (const auto& rule : cam_limits(scene, *cam)) {
        const int planes = testing_support::check_planes(
            *rule, [&](std::mt19937& random) { return random_place(*cam, random); }, ++seed);
        // Boxes that reach where the cam's formulas end have none.
        EXPECT_GE(planes, 500) << rule->origin().text();
    }
}

TEST_P(CamRules, PartialsAgreeWithDifferences) {
    const Scene scene = scene_of(GetParam());
    const auto cam = variables_of(scene);
    const auto rules = cam_limits(scene, *cam);
    EXPECT_GE(rules.size(), 6u);
    std::mt19937 random(3);
    constexpr double step = 1e-5;
    for (const auto& rule : rules) {
        for (int trial = 0; trial < 10; ++trial) {
            const Eigen::VectorXd place = random_place(*cam, random);
            const RuleValue value = at(*rule, place);
            const double size = std::max({1.0, std::abs(value.value), value.gradient.cwiseAbs().maxCoeff(),
                                          value.hessian.cwiseAbs().maxCoeff()});
            for (Eigen::Index j = 0; j < place.size(); ++j) {
                Eigen::VectorXd up = place, down = place;
                up[j] += step;
                down[j] -= step;
                const RuleValue above = at(*rule, up), below = at(*rule, down);
                EXPECT_NEAR(value.gradient[j], (above.value - below.value) / (2 * step), 1e-6 * size)
                    << rule->name() << ' ' << j;
                const Eigen::VectorXd column = (above.gradient - below.gradient) / (2 * step);
                EXPECT_LE((value.hessian.col(j) - column).cwiseAbs().maxCoeff(), 1e-5 * size)
                    << rule->name() << ' ' << j;
            }
        }
    }
}

TEST_P(CamRules, SatisfyTheirLinearityAndConvexityFlags) {
    const Scene scene = scene_of(GetParam());
    const auto cam = variables_of(scene);
    std::mt19937 random(5);
    int linear = 0;
    for (const auto& rule : cam_limits(scene, *cam)) {
        const Curvature claimed = rule->curvature(-0.1, 1.1);
        linear += claimed == Curvature::linear ? 1 : 0;
        EXPECT_EQ(rule->linear(), claimed == Curvature::linear) << rule->name();
        for (int trial = 0; trial < 200 && claimed != Curvature::general; ++trial) {
            const Eigen::VectorXd a = random_place(*cam, random), b = random_place(*cam, random);
            const double middle = at(*rule, 0.5 * (a + b)).value;
            const double chord = 0.5 * (at(*rule, a).value + at(*rule, b).value);
            EXPECT_LE(middle, chord + 1e-12) << rule->name();
            const double kink = claimed == Curvature::linear ? std::abs(middle - chord) : 0.0;
            EXPECT_LE(kink, 1e-12) << rule->name();
        }
    }
    if (GetParam().form == CamForm::open) {
        EXPECT_GE(linear, 1);  // the contact force at least
    }
}

TEST_P(CamRules, EnclosuresHoldTheirValues) {
    const Scene scene = scene_of(GetParam());
    const auto cam = variables_of(scene);
    std::mt19937 random(9);
    for (const auto& rule : cam_limits(scene, *cam))
        for (int trial = 0; trial < 20; ++trial) {
            const Eigen::VectorXd middle = random_place(*cam, random);
            std::array<Interval, 5> stretch;
            for (std::size_t r = 0; r < 4; ++r) {
                const double width = uniform(random, 0.0, 0.05), value = middle[static_cast<Eigen::Index>(r)];
                stretch[r] = Interval(value - width, value + width);
            }
            stretch[4] = Interval(-100.0, 100.0);
            const auto range = rule->range_along(0.0, stretch, middle.tail(middle.size() - 4));
            ASSERT_TRUE(range.has_value()) << rule->name();
            for (int place = 0; place < 10; ++place) {
                Eigen::VectorXd inside = middle;
                for (std::size_t r = 0; r < 4; ++r)
                    inside[static_cast<Eigen::Index>(r)] =
                        uniform(random, stretch[r].lower, stretch[r].upper);
                const double value = at(*rule, inside).value;
                EXPECT_TRUE(range->value.lower <= value + 1e-12 && value - 1e-12 <= range->value.upper)
                    << rule->name() << ' ' << value;
            }
        }
}

TEST(CamRules, BothSidesSatisfyTheirLimits) {
    // A least radius and a Hertz pressure each once a side; the pressure angle of a groove once, of two disks
    // twice; partners of a rule are told apart by their remark.
    const auto count = [](CamForm form, const std::string& name, const std::string& remark) {
        Scene scene = scene_of({FollowerType::oscillating_roller, Rotation::counterclockwise, false, form});
        int found = 0;
        for (const auto& rule : cam_limits(scene, *variables_of(scene)))
            if (rule->name().find(name) != std::string::npos && rule->origin().remark == remark) ++found;
        return found;
    };
    for (const char* side : {"inner flank", "outer flank"}) {
        EXPECT_EQ(count(CamForm::grooved, "cam_radius_min", side), 1) << side;
        EXPECT_EQ(count(CamForm::grooved, "concave_radius_min", side), 1) << side;
        EXPECT_EQ(count(CamForm::grooved, "undercut_margin", side), 1) << side;
        EXPECT_EQ(count(CamForm::grooved, "hertz_pressure_max", side), 1) << side;
    }
    EXPECT_EQ(count(CamForm::grooved, "rise_pressure_angle", ""),
              count(CamForm::open, "rise_pressure_angle", ""));
    for (const char* side : {"first disk", "second disk"}) {
        EXPECT_EQ(count(CamForm::conjugate, "rise_pressure_angle", side),
                  count(CamForm::open, "rise_pressure_angle", ""))
            << side;
        EXPECT_EQ(count(CamForm::conjugate, "hertz_pressure_max", side), 1) << side;
    }
}

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const FollowerType follower : {FollowerType::translating_roller, FollowerType::oscillating_roller})
        for (const CamForm form : {CamForm::grooved, CamForm::conjugate})
            for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise})
                for (const bool variable : {false, true}) all.push_back({follower, rotation, variable, form});
    for (const FollowerType follower :
         {FollowerType::translating_roller, FollowerType::translating_knife, FollowerType::translating_flat,
          FollowerType::oscillating_roller, FollowerType::oscillating_flat}) {
        for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise}) {
            for (const bool variable : {false, true}) all.push_back({follower, rotation, variable});
        }
    }
    return all;
}

INSTANTIATE_TEST_SUITE_P(All, CamRules, testing::ValuesIn(cases()), [](const auto& which) {
    return std::string(name_of(which.param.follower)) + "_" + name_of(which.param.rotation) +
           (which.param.variable ? "_variable_" : "_fixed_") + name_of(which.param.form);
});

TEST(CamRules, ArmPressureAngleIsLocallyConvex) {
    // docs/theory/pressure_angle.md: both sides convex where |ψ − 90°| <= φ_max.
    for (const double start_degrees : {75.0, 40.0}) {
        Scene scene = scene_of({FollowerType::oscillating_roller, Rotation::counterclockwise, false});
        scene.limits = {};
        scene.limits.pressure_angle = limit(30.0 * units::degree, "limits.pressure_angle_rad");
        const double a = 100e-3, l = 80e-3;
        const double prime = std::sqrt(a * a + l * l - 2 * a * l * std::cos(start_degrees * units::degree));
        scene.cam->set(base_radius, prime - 10e-3);
        int convex = 0;
        for (const auto& rule : cam_limits(scene, *variables_of(scene))) {
            convex += rule->curvature(-0.2, 1.2) == Curvature::convex ? 1 : 0;
        }
        EXPECT_EQ(convex, start_degrees == 75.0 ? 2 : 1);
    }
}

}  // namespace cam_rules_test
}  // namespace camopt
