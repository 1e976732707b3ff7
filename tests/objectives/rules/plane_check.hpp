// SPDX-License-Identifier: MIT
// Planes under a rule over random boxes: never above it, and nearer the smaller the box.
#pragma once

#include "objectives/boxes/rule_over_box.hpp"
#include "tests/support/long_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace camopt::testing_support {

/// ½ Σ a_i w_i².
inline double secant_error(const RuleOverBox& over) {
    double sum = 0.0;
    for (int i = 0; i < static_cast<int>(over.box().size()); ++i) sum += over.secant_error(i);
    return sum;
}

/// `place`: a random (y, y', y'', y''', q …); `at_x`: the cam angle's x. Returns how many boxes had planes.
inline int check_planes(const PointRule& rule, const std::function<Eigen::VectorXd(std::mt19937&)>& place,
                        unsigned seed, double at_x = 0.0) {
    constexpr int points = 10;
    const int boxes = scenes_to_try(1000, 10000);
    std::mt19937 random(seed);
    const auto share = [&] { return static_cast<double>(random()) / 4294967295.0; };
    int with_planes = 0, shrank = 0;
    for (int k = 0; k < boxes; ++k) {
        const Eigen::VectorXd middle = place(random);
        const double size = std::pow(10.0, -4.0 * share());
        std::vector<Interval> box, small;
        for (const double value : middle) {
            const double half = 0.1 * size * share() * std::max(0.1, std::abs(value));
            box.emplace_back(value - half, value + half);
            small.emplace_back(value - half / 16.0, value + half / 16.0);
        }
        const auto over = RuleOverBox::make(rule, box, at_x);
        if (!over) continue;
        Eigen::VectorXd at = middle;
        for (Eigen::Index i = 0; i < at.size(); ++i)
            at[i] +=
                (share() - 0.5) * 1.5 * box[static_cast<std::size_t>(i)].width();  // now and then outside
        const auto plane = over->plane(at);
        if (!plane) continue;
        ++with_planes;
        for (int n = 0; n < points; ++n) {
            Eigen::VectorXd z = middle;
            std::vector<Interval> point;
            for (Eigen::Index i = 0; i < z.size(); ++i) {
                const Interval& number = box[static_cast<std::size_t>(i)];
                // Corners too: there the secants touch.
                const double part = n < 3 ? (random() % 2 == 0 ? 0.0 : 1.0) : share();
                z[i] = std::clamp(number.lower + part * number.width(), number.lower, number.upper);
                point.emplace_back(z[i]);
            }
            const auto here = rule.range_over(point, at_x);
            EXPECT_TRUE(here);
            if (!here) return with_planes;
            const double height = plane->slope.dot(z) + plane->constant;
            const double rounding =
                1e-14 * (plane->slope.cwiseProduct(z).cwiseAbs().sum() + std::abs(plane->constant));
            EXPECT_LE(height, here->value.upper + rounding) << rule.name();
            EXPECT_LE(here->value.lower, over->most()) << rule.name();
            const double value = rule.evaluate({at_x, {z[0], z[1], z[2], z[3]}}, z.tail(z.size() - 4)).value;
            // The same limit: a positive multiple of the rule.
            if (std::abs(value) > 1e-9) {
                EXPECT_GT(value * (here->value.lower + here->value.upper), 0.0) << rule.name();
            }
            if (testing::Test::HasFailure()) return with_planes;
        }
        const auto closer = RuleOverBox::make(rule, small, at_x);
        EXPECT_TRUE(closer);
        if (closer && secant_error(*closer) <= secant_error(*over) / 128.0 + 1e-15) ++shrank;
    }
    // A sixteenth of the width, a two-hundred-and-fifty-sixth of the error, and what the enclosures gain.
    EXPECT_GE(shrank, with_planes * 99 / 100) << rule.name();
    return with_planes;
}

}  // namespace camopt::testing_support
