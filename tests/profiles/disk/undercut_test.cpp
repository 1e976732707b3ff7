// SPDX-License-Identifier: MIT
// The dimension at which a cam just begins to be undercut, against reference values that come from the
// positions of the follower alone.
#include "tests/profiles/test_turn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace camopt {
namespace disk_undercut_test {

using namespace test;

/// Golden section, to the rounding error of the least value.
double least_between(const std::function<double(double)>& function, double low, double high) {
    const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
    for (int i = 0; i < 60; ++i) {
        const double left = high - ratio * (high - low), right = low + ratio * (high - low);
        (function(left) < function(right) ? high : low) = function(left) < function(right) ? right : left;
    }
    return function(0.5 * (low + high));
}

/// The least regularity over the turn, continuously: every valley of a grid is followed to its bottom.
double least_regularity(const TestCam& cam) {
    const TestTurn turn;
    const auto regularity = [&](double theta) { return cam.at(theta, turn).regularity; };
    const auto at_degree = [&](int angle) { return regularity(angle * degree); };
    double least = at_degree(0);
    for (int angle = 1; angle < 360; ++angle) {
        if (at_degree(angle) > at_degree(angle - 1) || at_degree(angle) > at_degree(angle + 1)) continue;
        least = std::min(least, least_between(regularity, (angle - 1) * degree, (angle + 1) * degree));
    }
    return least;
}

/// Where the least regularity over the turn is 0; dimension in mm.
double threshold(const std::function<TestCam(double)>& make, double low, double high) {
    const bool rising = least_regularity(make(low)) < 0.0;
    EXPECT_NE(rising, least_regularity(make(high)) < 0.0);
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        ((least_regularity(make(middle)) < 0.0) == rising ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

TEST(Undercut, TranslatingRollerByPrimeRadius) {
    EXPECT_NEAR(threshold([](double prime) { return translating_roller(prime, 30); }, 35, 45), 39.0786636213,
                1e-10);
}

TEST(Undercut, TranslatingRollerByRollerRadius) {
    EXPECT_NEAR(threshold([](double roller) { return translating_roller(45, roller); }, 20, 44),
                34.5157351192, 1e-10);
}

TEST(Undercut, TranslatingFlatByBaseRadius) {
    EXPECT_NEAR(threshold([](double base) { return translating_flat(base); }, 10, 40), 21.9710456293, 1e-10);
}

TEST(Undercut, OscillatingRollerByRollerRadius) {
    EXPECT_NEAR(threshold([](double roller) { return oscillating_roller(roller); }, 30, 52), 45.8453197388,
                1e-10);
}

TEST(Undercut, OscillatingFlatByFaceOffset) {
    EXPECT_NEAR(threshold([](double offset) { return oscillating_flat(offset); }, 10, 35), 23.8336882750,
                1e-10);
}

}  // namespace disk_undercut_test
}  // namespace camopt
