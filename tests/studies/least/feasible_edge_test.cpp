// SPDX-License-Identifier: MIT
// The search for the edge of feasible values, on functions whose zero is known; numbers that people read.
#include "studies/least/feasible_edge.hpp"

#include <gtest/gtest.h>

#include <random>

namespace camopt {
namespace feasible_edge_test {

/// t(v), and how many values were tried.
struct Counted {
    std::function<double(double)> violation;
    int tried = 0;
    [[nodiscard]] ValueSearch search() {
        return {[this](double value) {
            ++tried;
            return violation(value);
        }};
    }
};

struct Form {
    const char* name;
    std::function<double(double)> violation;  ///< of v / zero
    int most;                                 ///< values tried
};
const Form forms[] = {{"line", [](double v) { return 1.0 - v; }, 8},
                      {"line without slack", [](double v) { return std::max(1.0 - v, 0.0); }, 14},
                      {"convex", [](double v) { return 1.0 / v - 1.0; }, 9},
                      {"convex without slack", [](double v) { return std::max(1.0 / v - 1.0, 0.0); }, 14},
                      {"two lines",
                       [](double v) {
                           return std::max({1.0 - v, 3.0 * (0.99 - v), 0.0});
                       },
                       14},
                      {"root", [](double v) { return v < 1.0 ? std::sqrt(1.0 - v) : 0.0; }, 36},
                      {"square", [](double v) { return v < 1.0 ? (1.0 - v) * (1.0 - v) : 0.0; }, 60},
                      {"nothing but the sign", [](double v) { return v < 1.0 ? infinity : 0.0; }, 30}};

TEST(FeasibleEdge, IsFoundOnEitherSide) {
    std::mt19937 random(7);
    for (const Form& form : forms)
        for (int k = 0; k < 20; ++k) {
            SCOPED_TRACE(form.name);
            const double zero = std::exp(std::uniform_real_distribution(-5.0, 5.0)(random));
            const double direction = k % 2 == 0 ? 1.0 : -1.0;  // feasible above, or below the mirrored zero
            Counted counted{[&](double value) { return form.violation(direction * value / zero); }};
            const double inside = std::uniform_real_distribution(1.001, 1.5)(random) * direction * zero,
                         outside = std::uniform_real_distribution(0.5, 0.999)(random) * direction * zero;
            const ValueSearch search = counted.search();
            ValueTrial from = search.at(inside);
            from.violation = std::min(from.violation, 0.0);
            const ValueBracket edge = closed_in(search, {from, search.at(outside)}, 1e-8 * zero);
            EXPECT_LE(edge.width(), 1e-8 * zero);
            EXPECT_LE(edge.inside.violation, 0.0);
            EXPECT_GT(edge.outside.violation, 0.0);
            EXPECT_NEAR(edge.inside.value, direction * zero, 1e-8 * zero);
            EXPECT_LE(counted.tried, form.most + 2);
        }
}

TEST(FeasibleEdge, MarchEndsAtChangeOrEnd) {
    const ValueSearch search{[](double value) { return 3.0 - value; }};
    const ValueMarch up = marched(search, search.at(0.0), 0.5, 100.0);
    ASSERT_TRUE(up.changed);
    EXPECT_EQ(up.last.value, 2.0);
    EXPECT_EQ(up.changed->value, 4.0);
    const ValueMarch down = marched(search, search.at(10.0), -1.0, 5.0);
    EXPECT_FALSE(down.changed);
    EXPECT_TRUE(down.at_end);
    EXPECT_EQ(down.last.value, 5.0);
}

TEST(FeasibleEdge, WholeNumbersStayWhole) {
    const ValueSearch search{[](double value) {
                                 EXPECT_EQ(value, std::floor(value));
                                 return value < 37.0 ? infinity : 0.0;
                             },
                             [] { return false; }, [](double value) { return std::floor(value); }};
    const ValueBracket edge = closed_in(search, {search.at(64.0), {12.0, infinity}}, 1.0);
    EXPECT_EQ(edge.inside.value, 37.0);
}

TEST(FeasibleEdge, ShortestDecimalLiesWithin) {
    EXPECT_EQ(shortest_decimal(10.1617, 10.1623), 10.162);
    EXPECT_EQ(shortest_decimal(10.1623, 10.1617), 10.162);
    EXPECT_EQ(shortest_decimal(-3.275, -3.21), -3.27);
    EXPECT_EQ(shortest_decimal(1234.0, 1267.0), 1240.0);
    EXPECT_EQ(shortest_decimal(0.0, 0.0), 0.0);
    std::mt19937 random(11);
    for (int k = 0; k < 1000; ++k) {
        const double size = std::pow(10.0, std::uniform_real_distribution(-9.0, 9.0)(random));
        const double near = size * std::uniform_real_distribution(-1.0, 1.0)(random);
        const double far = near + 1e-4 * size * std::uniform_real_distribution(-1.0, 1.0)(random);
        const double found = shortest_decimal(near, far);
        EXPECT_GE(found, std::min(near, far));
        EXPECT_LE(found, std::max(near, far));
    }
}

}  // namespace feasible_edge_test
}  // namespace camopt
