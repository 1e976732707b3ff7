// SPDX-License-Identifier: MIT
// The largest value along a motion: inside a piece, at its ends, of constants and where pieces meet.
#include "profiles/spatial/largest_along.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt::spatial_search {
namespace largest_along_test {

/// Pieces from 0 to 1 and to 3; of the state nothing is asked.
FollowerMotion two_pieces() {
    return {[](double) { return FollowerState{}; }, {0.0, 1.0, 3.0}};
}

TEST(LargestAlong, IsExactInsideAPiece) {
    const Extremum found = largest_along(two_pieces(), [](double at) { return std::cos(at - 1.7); });
    EXPECT_NEAR(found.at, 1.7, 1e-9);
    EXPECT_NEAR(found.value, 1.0, 1e-15);
}

TEST(LargestAlong, StaysInsideTheMotionWhereTheFunctionGrowsBeyondIt) {
    const Extremum first = largest_along(two_pieces(), [](double at) { return -at; });
    EXPECT_NEAR(first.at, 0.0, 1e-11);
    EXPECT_LE(first.value, 0.0);
    const Extremum last = largest_along(two_pieces(), [](double at) { return at; });
    EXPECT_NEAR(last.at, 3.0, 1e-11);
    EXPECT_LE(last.value, 3.0);
}

TEST(LargestAlong, OfAConstantIsAtTheFirstPlace) {
    const Extremum found = largest_along(two_pieces(), [](double) { return 2.0; });
    EXPECT_NEAR(found.at, 0.0, 1e-11);
    EXPECT_EQ(found.value, 2.0);
}

TEST(LargestAlong, LooksAtEachPieceByItself) {
    // A jump between the pieces: the second is larger, and falls.
    const Extremum found =
        largest_along(two_pieces(), [](double at) { return at < 1.0 ? at : 5.0 - 0.1 * at; });
    EXPECT_NEAR(found.at, 1.0, 1e-11);
    EXPECT_NEAR(found.value, 4.9, 1e-11);
}

TEST(LargestAlong, GoldenSectionsKeepTheLargerSide) {
    for (const double top : {0.05, 0.4, 0.95}) {
        const auto place =
            golden_maximum([top](double at) { return -std::abs(at - top); }, 0.0, 1.0, 40).place();
        EXPECT_NEAR(place, top, 1e-7);
    }
}

}  // namespace largest_along_test
}  // namespace camopt::spatial_search
