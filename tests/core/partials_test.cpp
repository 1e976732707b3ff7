// SPDX-License-Identifier: MIT
// Numbers with first and second partials: every operation against central differences of its value and of its
// gradient, and exact identities.
#include "core/partials.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace camopt {
namespace partials_test {

using Number = SecondOrder<3>;

struct Named {
    std::string name;
    std::function<Number(const Number& x, const Number& y, const Number& z)> made;
};

Number at(const Named& formula, const std::array<double, 3>& point) {
    return formula.made(variable<3>(point[0], 0), variable<3>(point[1], 1), variable<3>(point[2], 2));
}

const std::vector<Named>& formulas() {
    static const std::vector<Named> all = {
        {"sum", [](auto x, auto y, auto z) { return 2.0 + x - y + z * 3.0 - 1.5; }},
        {"difference", [](auto x, auto y, auto z) { return 1.0 - x * y - (-z) + +x; }},
        {"product", [](auto x, auto y, auto z) { return x * y * z * x; }},
        {"quotient", [](auto x, auto y, auto z) { return (x + y * z) / (y * y + x); }},
        {"of a number", [](auto x, auto y, auto z) { return 2.0 / (x * z) + y / 4.0; }},
        {"assigned",
         [](Number x, auto y, auto z) {
             x += y;
             x *= z;
             x -= y * y;
             x /= y;
             x *= 0.5;
             return x;
         }},
        {"sqrt", [](auto x, auto y, auto z) { return sqrt(x * y + z); }},
        {"exp log", [](auto x, auto y, auto z) { return exp(x * z) * log(y + x); }},
        {"pow",
         [](auto x, auto y, auto z) { return pow(x, 3.0) + pow(y, -1.5) + pow(x, z) + pow(2.0, y * z); }},
        {"sin cos", [](auto x, auto y, auto z) { return sin(x * y) * cos(z - y); }},
        {"tan atan", [](auto x, auto y, auto z) { return tan(0.3 * x * y) + atan(x - z); }},
        {"asin acos", [](auto x, auto y, auto z) { return asin(0.3 * x * z) * acos(0.2 * y); }},
        {"atan2",
         [](auto x, auto y, auto z) { return atan2(x * y, z) + atan2(-0.2 * x, -y) + atan2(y, 0.1 * z); }},
        {"hyperbolic", [](auto x, auto y, auto z) { return sinh(x) * cosh(y) - tanh(z * x); }},
        {"chosen",
         [](auto x, auto y, auto z) { return abs(-x * y) + min(x * x, 9.0 + z) + max(y * z, -5.0 * x); }}};
    return all;
}

TEST(SecondOrder, PartialsAreThoseOfDifferences) {
    constexpr double step = 1e-5, near = 2e-8;
    const std::array<double, 3> point = {0.7, 1.3, 0.9};
    for (const Named& formula : formulas()) {
        const Number found = at(formula, point);
        const Eigen::Matrix3d hessian = found.hessian();
        for (int i = 0; i < 3; ++i) {
            std::array<double, 3> above = point, below = point;
            above[static_cast<std::size_t>(i)] += step;
            below[static_cast<std::size_t>(i)] -= step;
            const Number up = at(formula, above), down = at(formula, below);
            EXPECT_NEAR(found.gradient()(i), (up.value - down.value) / (2.0 * step), near) << formula.name;
            const Eigen::Vector3d slope = (up.gradient() - down.gradient()) / (2.0 * step);
            EXPECT_LT((hessian.col(i) - slope).norm(), near) << formula.name << " by " << i;
        }
    }
}

TEST(SecondOrder, PolynomialsAreExact) {
    const Number x = variable<3>(0.5, 0), y = variable<3>(-2.0, 1), constant_one = constant<3>(1.0);
    const Number found = x * x * y + constant_one;
    EXPECT_EQ(found.value, 0.5);
    EXPECT_EQ(found.gradient(), Eigen::Vector3d(-2.0, 0.25, 0.0));
    EXPECT_EQ(found.hessian()(0, 0), -4.0);
    EXPECT_EQ(found.hessian()(0, 1), 1.0);
    EXPECT_EQ(found.hessian()(1, 0), 1.0);
    EXPECT_EQ(found.hessian()(1, 1), 0.0);
    EXPECT_TRUE(x > y && y < x && x >= y && y <= x && x < 1.0);
}

/// Where the power is a whole number the base may be 0 or below.
TEST(SecondOrder, WholePowersHoldEverywhere) {
    for (const double base : {0.0, -2.0}) {
        const SecondOrder<1> x = variable<1>(base, 0);
        EXPECT_EQ(pow(x, 2.0).value, base * base);
        EXPECT_EQ(pow(x, 2.0).first[0], 2.0 * base);
        EXPECT_EQ(pow(x, 2.0).second[0], 2.0);
        EXPECT_EQ(pow(x, 1.0).second[0], 0.0);
        EXPECT_EQ(pow(x, 0.0).first[0], 0.0);
    }
}

}  // namespace partials_test
}  // namespace camopt
