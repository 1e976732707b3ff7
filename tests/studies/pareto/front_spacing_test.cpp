// SPDX-License-Identifier: MIT
#include "studies/pareto/front_chain.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace front_spacing_test {

const std::vector<FrontPlace> places = {
    {{0.0, 1.0}, false}, {{0.3, 0.6}, true}, {{0.6, 0.4}, false}, {{1.0, 0.1}, false}};

TEST(FrontSpacing, JumpsHaveNoLength) {
    const std::vector<double> arc = arc_lengths(places);
    ASSERT_EQ(arc.size(), 4U);
    EXPECT_DOUBLE_EQ(arc[1], 0.5);
    EXPECT_DOUBLE_EQ(arc[2], 0.5);
    EXPECT_DOUBLE_EQ(arc[3], 1.0);
}

TEST(FrontSpacing, TargetsLieOnNonemptyPieces) {
    const std::vector<double> arc = arc_lengths(places);
    const FrontTarget first = target_at(arc, 0.25), second = target_at(arc, 0.6);
    EXPECT_EQ(first.after, 0);
    EXPECT_DOUBLE_EQ(first.part, 0.5);
    EXPECT_EQ(second.after, 2);
    EXPECT_NEAR(second.part, 0.2, 1e-12);
    EXPECT_EQ(target_at(arc, 2.0).after, 2);
    EXPECT_DOUBLE_EQ(target_at(arc, 2.0).part, 1.0);
    EXPECT_EQ(target_at(arc, 0.0).after, 0);
}

TEST(FrontSpacing, FindsLongestPieceAndNearestPoint) {
    std::vector<FrontPlace> more = places;
    more[2].box = {0.9, 0.2};
    EXPECT_EQ(longest_piece(more), 0);
    const std::vector<FrontPlace> closed = {{{0.0, 1.0}, true}, {{1.0, 0.0}, false}};
    EXPECT_EQ(longest_piece(closed), -1);
    EXPECT_EQ(nearest_place(arc_lengths(places), 0.45), 1);
    EXPECT_EQ(nearest_place(arc_lengths(places), 0.9), 3);
}

}  // namespace front_spacing_test
}  // namespace camopt
