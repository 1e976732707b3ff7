// SPDX-License-Identifier: MIT
#include "core/numbers/extremum.hpp"
#include "core/numbers/polynomial.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace camopt {
namespace scalar_search_test {

TEST(GoldenSections, FindMaximumAtAnyLocation) {
    for (const double top : {0.0, 0.01, 0.3, 0.5, 0.77, 1.0}) {
        const auto peak = [top](double x) { return 2.0 - std::abs(x - top); };
        const GoldenSection found = golden_maximum(peak, 0.0, 1.0, 60);
        EXPECT_NEAR(found.place(), top, 1e-11);
        EXPECT_NEAR(found.value(), 2.0, 1e-11);
        EXPECT_LE(found.low, found.left);
        EXPECT_LE(found.right, found.high);
    }
}

TEST(GoldenSections, EndWhereItIsEnough) {
    int calls = 0;
    const auto counted = [&](double x) {
        ++calls;
        return -x * x;
    };
    const GoldenSection found = golden_maximum(counted, -1.0, 2.0, 100, [](const GoldenSection& section) {
        return section.high - section.low < 0.1;
    });
    EXPECT_LT(found.high - found.low, 0.1);
    EXPECT_EQ(calls, 2 + 8);  // 3 · 0.618^8 = 0.064
}

TEST(Bisection, LeadsToNeighbouringNumbersOnEitherSide) {
    const auto holds = [](double x) { return x * x < 2.0; };
    for (const double from : {0.0, 1.0}) {
        const Border border = bisected(holds, {from, 3.0}, 80);
        EXPECT_TRUE(holds(border.with));
        EXPECT_FALSE(holds(border.without));
        EXPECT_LE(border.without - border.with, 2.0 * std::numeric_limits<double>::epsilon());
    }
    const Border downwards = bisected([](double x) { return x > 0.25; }, {1.0, 0.0}, 80);
    EXPECT_NEAR(downwards.with, 0.25, 1e-15);
}

TEST(GaussLegendre, IsExactToDegreeNine) {
    for (int degree = 0; degree < 10; ++degree) {
        double sum = 0.0;
        for (const QuadraturePoint& point : gauss_legendre)
            sum += point.weight * std::pow(point.place, degree);
        EXPECT_NEAR(sum, degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0, 1e-15) << "degree " << degree;
    }
}

}  // namespace scalar_search_test
}  // namespace camopt
