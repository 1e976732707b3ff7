// SPDX-License-Identifier: MIT
// Quantities at random states, in extreme sizes, and as those of a mechanism. Their values against the points
// and their partials: tests/profiles/every_kind_test.cpp.
#include "core/errors.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "tests/profiles/test_turn.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <random>

namespace camopt {
namespace disk_quantity_test {

using namespace test;
using enum DimensionIndex;

constexpr MechanismQuantity every_quantity[] = {
    MechanismQuantity::pressure_numerator, MechanismQuantity::pressure_denominator,
    MechanismQuantity::pitch_curvature,    MechanismQuantity::cam_radius,
    MechanismQuantity::regularity,         MechanismQuantity::contact_offset,
    MechanismQuantity::normal_lever};

bool has_quantity(FollowerType follower, MechanismQuantity which) {
    if (which == MechanismQuantity::pitch_curvature) return !has_flat_face(follower);
    if (which == MechanismQuantity::cam_radius || which == MechanismQuantity::contact_offset)
        return has_flat_face(follower);
    return true;
}

struct Situation {
    DiskCam cam;
    FollowerState state;
};

/// A cam that can be built, dimensions around 50 mm, in a state of a lively motion.
Situation random_situation(FollowerType follower, Rotation rotation, std::mt19937& generator) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution(low, high)(generator);
    };
    Situation situation{{follower, rotation, {}}, {}};
    const std::array<std::array<double, 2>, dimension_count> ranges = {
        {{0.03, 0.06}, {0.005, 0.02}, {-0.02, 0.02}, {0.09, 0.11}, {0.07, 0.085}, {-0.01, 0.02}}};
    for (int i = 0; i < dimension_count; ++i)
        if (has_dimension(follower, static_cast<DimensionIndex>(i)))
            situation.cam.dimensions[i] = between(ranges[i][0], ranges[i][1]);
    const double size = is_oscillating(follower) ? 0.4 : 0.03;
    situation.state = {between(0.0, size), between(-size, size), between(-2.0 * size, 2.0 * size)};
    EXPECT_EQ(geometry_fault(situation.cam, 0.0, situation.state.s), "");
    return situation;
}

struct Case {
    FollowerType follower;
    Rotation rotation;
};

class QuantityOf : public ::testing::TestWithParam<Case> {
 protected:
    /// `body` at seeded random situations of the case.
    static void repeat(const std::function<void(const Situation&)>& body) {
        std::mt19937 generator(20240717U);
        for (int i = 0; i < 25; ++i)
            body(random_situation(GetParam().follower, GetParam().rotation, generator));
    }
};

QuantityValue value_of(const Situation& situation, MechanismQuantity which) {
    return quantity(situation.cam, situation.state, which);
}

/// The lever is what the principle of virtual work says: the normal's part along the follower's velocity.
TEST_P(QuantityOf, LeverIsNormalContactVelocity) {
    repeat([](const Situation& situation) {
        const ProfilePoint point = profile_point(situation.cam, 0.0, situation.state);
        Eigen::Vector2d velocity(0.0, 1.0);
        if (is_oscillating(situation.cam.follower)) {
            const Eigen::Vector2d arm = point.contact - Eigen::Vector2d(situation.cam[center_distance], 0.0);
            velocity = Eigen::Vector2d(arm.y(), -arm.x());
        }
        EXPECT_NEAR(value_of(situation, MechanismQuantity::normal_lever).value, point.normal.dot(velocity),
                    1e-15);
    });
}

TEST_P(QuantityOf, RefusesWhatTheFollowerHasNot) {
    repeat([](const Situation& situation) {
        for (const MechanismQuantity which : every_quantity) {
            if (has_quantity(situation.cam.follower, which)) continue;
            EXPECT_THROW((void)value_of(situation, which), ModelError);
        }
    });
}

/// Lifts of 1e-6 m and 1 m on cams of their size, and a lift of 1e-6 m on one of 45 mm.
TEST(ExtremeQuantities, StayFinite) {
    const TestTurn turn;
    for (const TestCam& cam : regular_cams())
        for (const auto& [size, lift] :
             {std::pair(4e-5, 4e-5), std::pair(40.0, 40.0), std::pair(1.0, 4e-5)}) {
            DiskCam scaled = cam.cam;
            for (double& dimension : scaled.dimensions) dimension *= size;
            const double scaled_lift = is_oscillating(cam.cam.follower) ? cam.lift : cam.lift * lift;
            for (const double theta : angles(0.0, 7.5))
                for (const MechanismQuantity which : every_quantity) {
                    if (!has_quantity(scaled.follower, which)) continue;
                    const FollowerState state = state_of(turn.at(theta, Side::right), {scaled_lift, 1.0});
                    const QuantityValue value = quantity(scaled, state, which);
                    ASSERT_TRUE(std::isfinite(value.value)) << cam.name << " " << theta;
                    ASSERT_TRUE(value.gradient.allFinite()) << cam.name << " " << theta;
                    ASSERT_TRUE(value.hessian.allFinite()) << cam.name << " " << theta;
                }
        }
}

/// The same numbers behind the interface of any cam.
TEST_P(QuantityOf, IsTheSameOfTheMechanism) {
    std::mt19937 generator(20);
    const auto [follower, rotation] = GetParam();
    for (int again = 0; again < 20; ++again) {
        const Situation situation = random_situation(follower, rotation, generator);
        const DrivenMechanism mechanism = disk_mechanism(situation.cam);
        ASSERT_TRUE(disk_cam(mechanism));
        EXPECT_EQ(disk_cam(mechanism)->dimensions, situation.cam.dimensions);
        const MechanismState state{mechanism.dimensions, situation.state};
        const ProfilePoint own = profile_point(situation.cam, 0.7, situation.state);
        const MechanismPoint point = mechanism.formulas->point(0.7, state, 0);
        EXPECT_EQ(point.contact.head<2>(), own.contact);
        EXPECT_EQ(point.pressure_angle, own.pressure_angle);
        EXPECT_EQ(point.regularity, own.regularity);
        std::vector<int> active(mechanism.dimensions.size()), columns = {0, 1, 2};
        std::iota(active.begin(), active.end(), 0);
        for (int i = 0; i < dimension_count; ++i)
            if (has_dimension(follower, static_cast<DimensionIndex>(i))) columns.push_back(3 + i);
        for (const auto& [which, all] :
             {std::pair(MechanismQuantity::regularity, MechanismQuantity::regularity),
              std::pair(MechanismQuantity::pressure_numerator, MechanismQuantity::pressure_numerator)}) {
            const MechanismValue value = mechanism.formulas->quantity(which, state, 0, active);
            const QuantityValue expected = quantity(situation.cam, situation.state, all);
            EXPECT_EQ(value.value, expected.value);
            EXPECT_EQ(value.gradient, expected.gradient(columns));
            EXPECT_EQ(value.hessian, expected.hessian(columns, columns));
        }
    }
}

std::vector<Case> every_case() {
    std::vector<Case> cases;
    for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise})
        for (const FollowerType follower : {FollowerType::translating_roller, FollowerType::translating_knife,
                                            FollowerType::translating_flat, FollowerType::oscillating_roller,
                                            FollowerType::oscillating_flat})
            cases.push_back({follower, rotation});
    return cases;
}

INSTANTIATE_TEST_SUITE_P(All, QuantityOf, ::testing::ValuesIn(every_case()), [](const auto& item) {
    return std::string(name_of(item.param.follower)) + "_" + name_of(item.param.rotation);
});

}  // namespace disk_quantity_test
}  // namespace camopt
