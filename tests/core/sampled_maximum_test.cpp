// SPDX-License-Identifier: MIT
// The largest value along a motion: inside a piece, at its ends, of constants and where pieces meet.
#include "core/numbers/extremum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace camopt {
namespace sampled_maximum_test {

const std::vector<double> two_pieces = {0.0, 1.0, 3.0};

TEST(LargestAlong, IsExactInsideAPiece) {
    const Extremum found = largest_along(two_pieces, [](double at, Side) { return std::cos(at - 1.7); });
    EXPECT_NEAR(found.at, 1.7, 1e-9);
    EXPECT_NEAR(found.value, 1.0, 1e-15);
    const Extremum least = least_along(two_pieces, [](double at, Side) { return std::pow(at - 0.3, 4); });
    EXPECT_NEAR(least.value, 0.0, 1e-15);
}

TEST(LargestAlong, StaysInsideMotion) {
    const Extremum first = largest_along(two_pieces, [](double at, Side) { return -at; });
    EXPECT_EQ(first.at, 0.0);
    const Extremum last = largest_along(two_pieces, [](double at, Side) { return at; });
    EXPECT_EQ(last.at, 3.0);
    EXPECT_EQ(last.side, Side::left);
}

TEST(LargestAlong, ConstantReportsFirstLocation) {
    const Extremum found = largest_along(two_pieces, [](double, Side) { return 2.0; });
    EXPECT_EQ(found.at, 0.0);
    EXPECT_EQ(found.value, 2.0);
}

TEST(LargestAlong, SearchesEachPieceSeparately) {
    // A jump between the pieces: the second is larger, and falls.
    const auto jumping = [](double at, Side side) {
        return at < 1.0 || (at == 1.0 && side == Side::left) ? at : 5.0 - 0.1 * at;
    };
    const Extremum found = largest_along(two_pieces, jumping);
    EXPECT_EQ(found.at, 1.0);
    EXPECT_NEAR(found.value, 4.9, 1e-15);
}

TEST(LargestAlong, FindsKinksAndSkipsUndefinedValues) {
    const Extremum kink =
        largest_along(two_pieces, [](double at, Side) { return 1.0 - std::abs(at - 2.3456789); });
    EXPECT_NEAR(kink.at, 2.3456789, 1e-7);
    EXPECT_NEAR(kink.value, 1.0, 1e-7);
    const Extremum half = largest_along(two_pieces, [](double at, Side) {
        return at < 1.0 ? std::numeric_limits<double>::quiet_NaN() : std::sin(at);
    });
    EXPECT_NEAR(half.value, 1.0, 1e-15);
}

}  // namespace sampled_maximum_test
}  // namespace camopt
