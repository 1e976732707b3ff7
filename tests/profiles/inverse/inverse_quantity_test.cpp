// SPDX-License-Identifier: MIT
// Quantities of limits: values against the guide, first and second partials against differences.
#include "profiles/inverse/inverse_quantity.hpp"

#include "reference_machine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {

namespace inverse_quantity_test {

using test::inch;

FollowerState moved(FollowerState state, int variable, double by) {
    (variable == 0 ? state.s : variable == 1 ? state.velocity : state.acceleration) += by;
    return state;
}

TEST(InverseQuantity, ValuesAreThoseOfTheGuide) {
    const Guide guide = make_g1_guide(test::forward_dimensions());
    const FeederLinkage linkage = test::reference_linkage();
    for (const double time : {0.09, 0.1, 0.125, 0.14, 0.165, 0.18, 0.2}) {
        const RollerState roller = test::reference_roller().at(time);
        const InverseState state = inverse_state(guide, linkage, roller);
        const auto value = [&](InverseQuantity which) {
            return inverse_quantity(linkage, roller, state.feeder.feeder, which).value;
        };
        EXPECT_NEAR(value(InverseQuantity::pressure_numerator) / value(InverseQuantity::pressure_denominator),
                    std::tan(state.pressure_angle), 1e-12);
        EXPECT_NEAR(value(InverseQuantity::guide_curvature), state.curvature,
                    1e-9 * std::abs(state.curvature) + 1e-9);
    }
}

TEST(InverseQuantity, PartialsAgainstDifferences) {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    const FeederLinkage linkage = test::reference_linkage();
    for (int round = 0; round < 200; ++round) {
        const RollerState roller{(8.0 + 4.0 * part(generator)) * inch,
                                 (100.0 + 30.0 * part(generator)) * inch, 1000.0 * part(generator) * inch};
        const FollowerState feeder{(0.5 + part(generator)) * inch, 80.0 * part(generator) * inch,
                                   3000.0 * part(generator) * inch};
        const double steps[] = {1e-5 * inch, 1e-3 * inch, 0.1 * inch};
        for (const auto which : {InverseQuantity::pressure_numerator, InverseQuantity::guide_curvature}) {
            const auto value = inverse_quantity(linkage, roller, feeder, which);
            ASSERT_EQ(value.fault, InverseFault::none);
            for (int i = 0; i < 3; ++i) {
                const auto after = inverse_quantity(linkage, roller, moved(feeder, i, steps[i]), which);
                const auto before = inverse_quantity(linkage, roller, moved(feeder, i, -steps[i]), which);
                const double slope = (after.value - before.value) / (2 * steps[i]);
                EXPECT_NEAR(value.gradient(i), slope,
                            1e-6 * (std::abs(slope) + std::abs(value.value) / steps[i] * 1e-4));
                const Eigen::Vector3d row = (after.gradient - before.gradient) / (2 * steps[i]);
                for (int k = 0; k < 3; ++k)
                    EXPECT_NEAR(value.hessian(i, k), row(k),
                                1e-6 * (std::abs(row(k)) + std::abs(value.gradient(k)) / steps[i] * 1e-4));
            }
            EXPECT_TRUE(value.hessian.isApprox(value.hessian.transpose(), 1e-12));
        }
    }
}

TEST(InverseQuantity, NamesItsFault) {
    const auto value = inverse_quantity(test::reference_linkage(), {0.2, 1.0, 0.0}, {2.0, 0.0, 0.0},
                                        InverseQuantity::guide_curvature);
    EXPECT_EQ(value.fault, InverseFault::rocker_misses_pin);
    EXPECT_EQ(value.value, 0.0);
}

}  // namespace inverse_quantity_test

}  // namespace camopt
