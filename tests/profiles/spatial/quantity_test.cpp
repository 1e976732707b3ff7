// SPDX-License-Identifier: MIT
// Quantities against the points, and their partials against fourth-order central differences.
#include "situations.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace spatial_quantity_test {

using namespace test;

constexpr SpatialQuantity every_quantity[] = {
    SpatialQuantity::pressure_numerator, SpatialQuantity::pressure_denominator, SpatialQuantity::undercut};

SpatialValue value_of(const Situation& at, SpatialQuantity which) {
    return spatial_quantity(at.cam, at.state, at.station, which);
}

/// Typical size of each variable.
double size_of(const Situation& at, int variable) {
    return variable < 3 && at.cam.follower != SpatialFollower::cylindrical_translating ? 0.4 : 0.04;
}

template <class Function>
auto difference(const Function& function, const Situation& situation, int variable) {
    const double step = 5e-4 * size_of(situation, variable);
    const auto at = [&](double steps) {
        Situation moved = situation;
        moved.variable(variable) += steps * step;
        return function(moved);
    };
    using Result = decltype(function(situation));
    return Result((8.0 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12.0 * step));
}

class SpatialQuantityOf : public ::testing::TestWithParam<Case> {};

TEST_P(SpatialQuantityOf, AgreesWithThePoint) {
    repeat(GetParam(), [](const Situation& at) {
        const SpatialPoint point = spatial_point(at.cam, at.theta, at.state, at.station);
        const double numerator = value_of(at, SpatialQuantity::pressure_numerator).value;
        const double denominator = value_of(at, SpatialQuantity::pressure_denominator).value;
        EXPECT_GT(denominator, 0.0);
        EXPECT_NEAR(std::atan2(numerator, denominator), point.pressure_angle, 1e-14);
        EXPECT_NEAR(value_of(at, SpatialQuantity::undercut).value, point.undercut, 1e-14);
    });
}

TEST_P(SpatialQuantityOf, PartialsAreThoseOfDifferences) {
    repeat(GetParam(), [](const Situation& at) {
        for (const SpatialQuantity which : every_quantity) {
            const SpatialValue exact = value_of(at, which);
            const double unit = which == SpatialQuantity::undercut ? 1.0 : 0.1;
            for (int i = 0; i < spatial_variables; ++i) {
                const double slope =
                    difference([&](const Situation& moved) { return value_of(moved, which).value; }, at, i);
                EXPECT_NEAR(exact.gradient(i), slope, 1e-9 * unit / size_of(at, i));
                const Eigen::Matrix<double, spatial_variables, 1> row = difference(
                    [&](const Situation& moved) { return value_of(moved, which).gradient; }, at, i);
                for (int k = 0; k < spatial_variables; ++k)
                    EXPECT_NEAR(exact.hessian(k, i), row(k), 1e-8 * unit / (size_of(at, i) * size_of(at, k)))
                        << i << " " << k;
            }
            EXPECT_EQ(exact.hessian, exact.hessian.transpose().eval());
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Spatial, SpatialQuantityOf, ::testing::ValuesIn(every_case()), case_name);

}  // namespace spatial_quantity_test
}  // namespace camopt
