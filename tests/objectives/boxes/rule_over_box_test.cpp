// SPDX-License-Identifier: MIT
// Planes under a rule over a box: below it everywhere, and those of a product are its convex envelope.
#include "objectives/boxes/rule_over_box.hpp"

#include "objectives/rules/torque_rule.hpp"

#include <gtest/gtest.h>

#include <random>

namespace camopt {
namespace rule_over_box_test {

double uniform(std::mt19937& random, const Interval& range) {
    return range.lower + range.width() * static_cast<double>(random()) / 4294967295.0;
}

/// McCormick: the convex envelope of sign · y' y'' over a box of both.
double envelope(int sign, const Interval& a, const Interval& b, double x, double y) {
    if (sign > 0)
        return std::max(a.lower * y + b.lower * x - a.lower * b.lower,
                        a.upper * y + b.upper * x - a.upper * b.upper);
    return -std::min(a.upper * y + b.lower * x - a.upper * b.lower,
                     a.lower * y + b.upper * x - a.lower * b.upper);
}

TEST(RuleOverBox, TorquePlanesFormItsEnvelope) {
    std::mt19937 random(7);
    constexpr double reference = 3.0;
    for (int trial = 0; trial < 200; ++trial) {
        const int sign = trial % 2 == 0 ? 1 : -1;
        const TorqueRule rule(sign, 0, reference);
        std::vector<Interval> box(5, Interval(0.0));
        for (const std::size_t i : {1u, 2u, 4u}) {
            const double middle = uniform(random, {-2.0, 2.0});
            box[i] = {middle - uniform(random, {0.1, 2.0}), middle + uniform(random, {0.1, 2.0})};
        }
        const auto over = RuleOverBox::make(rule, box, 0.5);
        ASSERT_TRUE(over);
        for (int point = 0; point < 20; ++point) {
            Eigen::VectorXd at(5), other(5);
            for (Eigen::Index i = 0; i < 5; ++i) {
                at[i] = uniform(random, box[static_cast<std::size_t>(i)]);
                other[i] = uniform(random, box[static_cast<std::size_t>(i)]);
            }
            const auto plane = over->plane(at);
            ASSERT_TRUE(plane);
            const double there = plane->slope.dot(at) + plane->constant;
            EXPECT_NEAR(there, envelope(sign, box[1], box[2], at[1], at[2]) / reference - at[4], 1e-12);
            EXPECT_LE(plane->slope.dot(other) + plane->constant,
                      sign * other[1] * other[2] / reference - other[4] + 1e-15);
        }
    }
}

}  // namespace rule_over_box_test
}  // namespace camopt
