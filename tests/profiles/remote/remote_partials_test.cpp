// SPDX-License-Identifier: MIT
// Quantities against the points, and their partials by (s, s', s'', every dimension) against fourth-order
// central differences, at random states of every linkage.
#include "tappet.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {
namespace remote_partials_test {

using namespace test;

constexpr MechanismQuantity every_quantity[] = {
    MechanismQuantity::pressure_numerator, MechanismQuantity::pressure_denominator,
    MechanismQuantity::pitch_curvature, MechanismQuantity::regularity};

struct Situation {
    std::vector<double> numbers;
    FollowerState state;

    [[nodiscard]] double& variable(int index) {
        double* const states[] = {&state.s, &state.velocity, &state.acceleration};
        return index < 3 ? *states[index] : numbers[static_cast<std::size_t>(index - 3)];
    }
    [[nodiscard]] MechanismState mechanism() const { return {numbers, state}; }
};

struct Case {
    RemoteLinkage linkage;
    Rotation rotation;
    PressurePoint where;
};

class RemoteQuantity : public ::testing::TestWithParam<Case> {
 protected:
    RemoteQuantity() : spec(tappet()) {
        const Case& own = GetParam();
        spec.choices["linkage"] = name_of(own.linkage);
        spec.choices["pressure_angle_at"] = name_of(own.where);
        spec.rotation = own.rotation;
        set(spec, rocker_angle, 3);
        set(spec, output_angle, own.linkage == RemoteLinkage::lever ? -5 : 185);
        if (own.linkage == RemoteLinkage::lever_coupler_slider) {
            set(spec, slider_x, 110);
            set(spec, slider_y, 350);
        }
    }

    [[nodiscard]] Situation random(std::mt19937& generator) const {
        const auto near = [&](double value, double width) {
            return value + width * std::uniform_real_distribution(-1.0, 1.0)(generator);
        };
        Situation situation{spec.middle(), {}};
        for (int i = 0; i < remote_dimension_count; ++i)
            situation.variable(3 + i) =
                near(situation.variable(3 + i), is_angle(static_cast<RemoteDimension>(i)) ? 0.02 : 0.002);
        const bool swings = output_swings(GetParam().linkage);
        const double size = swings ? 0.1 : 0.04;
        situation.state = {near(size, 0.9 * size), near(0.0, size), near(0.0, 2.0 * size)};
        return situation;
    }

    CamSpec spec;
};

TEST_P(RemoteQuantity, IsWhatThePointSays) {
    std::mt19937 generator(1);
    const RemoteCam cam(spec);
    for (int trial = 0; trial < 20; ++trial) {
        const Situation situation = random(generator);
        const MechanismPoint point = cam.point(0.3, situation.mechanism(), 0);
        const auto value = [&](MechanismQuantity which) {
            return cam.quantity(which, situation.mechanism(), 0, {}).value;
        };
        EXPECT_GT(value(MechanismQuantity::pressure_denominator), 0.0);
        EXPECT_NEAR(
            value(MechanismQuantity::pressure_numerator) / value(MechanismQuantity::pressure_denominator),
            std::tan(point.pressure_angle), 1e-13);
        EXPECT_NEAR(value(MechanismQuantity::pitch_curvature), point.pitch_curvature, 1e-12);
        EXPECT_NEAR(value(MechanismQuantity::regularity), point.regularity, 1e-13);
    }
}

TEST_P(RemoteQuantity, PartialsAreTheDifferences) {
    std::mt19937 generator(2);
    const RemoteCam cam(spec);
    std::vector<int> active;
    for (int i = 0; i < remote_dimension_count; ++i)
        if (has_dimension(GetParam().linkage, static_cast<RemoteDimension>(i))) active.push_back(i);
    const int size = 3 + static_cast<int>(active.size());
    const auto index = [&](int k) { return k < 3 ? k : 3 + active[static_cast<std::size_t>(k - 3)]; };
    for (int trial = 0; trial < 1; ++trial) {
        const Situation situation = random(generator);
        for (const MechanismQuantity which : every_quantity) {
            const MechanismValue exact = cam.quantity(which, situation.mechanism(), 0, active);
            ASSERT_EQ(exact.gradient.size(), size);
            EXPECT_LT((exact.hessian - exact.hessian.transpose()).norm(), 1e-9 * exact.hessian.norm());
            for (int k = 0; k < size; ++k) {
                const double step = 2e-5;
                const auto at = [&](double steps) {
                    Situation moved = situation;
                    moved.variable(index(k)) += steps * step;
                    return cam.quantity(which, moved.mechanism(), 0, active);
                };
                const MechanismValue a = at(1), b = at(-1), c = at(2), d = at(-2);
                const double first = (8 * (a.value - b.value) - (c.value - d.value)) / (12 * step);
                EXPECT_NEAR(exact.gradient(k), first, 1e-7 * (exact.gradient.norm() + std::abs(exact.value)))
                    << "quantity " << int(which) << ", variable " << k;
                const Eigen::VectorXd second =
                    (8 * (a.gradient - b.gradient) - (c.gradient - d.gradient)) / (12 * step);
                EXPECT_LT((exact.hessian.col(k) - second).norm(),
                          1e-6 * (exact.hessian.norm() + exact.gradient.norm()))
                    << "quantity " << int(which) << ", variable " << k;
            }
        }
    }
}

TEST_P(RemoteQuantity, PartialsOfSubsetMatchAll) {
    std::mt19937 generator(3);
    const RemoteCam cam(spec);
    const Situation situation = random(generator);
    const std::vector<int> all = {0, 1, 2}, one = {1};
    for (const MechanismQuantity which : every_quantity) {
        const MechanismValue full = cam.quantity(which, situation.mechanism(), 0, all);
        const MechanismValue part = cam.quantity(which, situation.mechanism(), 0, one);
        const MechanismValue none = cam.quantity(which, situation.mechanism(), 0, {});
        EXPECT_EQ(full.value, part.value);
        EXPECT_NEAR(full.gradient(4), part.gradient(3), 1e-12 * full.gradient.norm());
        EXPECT_NEAR(full.hessian(4, 2), part.hessian(3, 2), 1e-12 * full.hessian.norm());
        EXPECT_LT((full.hessian.topLeftCorner(3, 3) - none.hessian).norm(),
                  1e-12 * none.hessian.norm() + 1e-15);
    }
}

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const RemoteLinkage linkage :
         {RemoteLinkage::lever, RemoteLinkage::lever_coupler_slider, RemoteLinkage::lever_coupler_lever,
          RemoteLinkage::lever_coupler_lever_coupler_slider})
        for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise})
            for (const PressurePoint where : {PressurePoint::roller_center, PressurePoint::contact_point})
                all.push_back({linkage, rotation, where});
    return all;
}

INSTANTIATE_TEST_SUITE_P(EveryLinkage, RemoteQuantity, ::testing::ValuesIn(cases()), [](const auto& one) {
    return std::string(name_of(one.param.linkage)) + "_" + name_of(one.param.rotation) + "_" +
           name_of(one.param.where);
});

}  // namespace remote_partials_test
}  // namespace camopt
