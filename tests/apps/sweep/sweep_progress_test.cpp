// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_progress.hpp"

#include <gtest/gtest.h>

namespace camopt::apps {
namespace sweep_progress_test {

TEST(SweepProgress, CountsRowsOnceAndEstimatesRest) {
    const Chunking chunking{100, 10};
    SweepProgress progress(chunking, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, {2, 3, 4, 5, 6, 7, 8, 9});
    EXPECT_EQ(progress.text(0.0), "[####--------------------] 20 of 100 rows, 0 s");
    for (int row = 20; row < 40; ++row) progress.add(row);
    progress.add(20);  // again: its worker died
    progress.add(1000);
    // 20 rows in 10 s: 60 more take 30 s.
    EXPECT_EQ(progress.text(10.0), "[#########---------------] 40 of 100 rows, 10 s, about 30 s left");
    for (int row = 40; row < 100; ++row) progress.add(row);
    EXPECT_EQ(progress.text(40.0), "[########################] 100 of 100 rows, 40 s");
}

TEST(SweepProgress, AShardCountsItsOwnRows) {
    SweepProgress progress({25, 10}, {0, 2}, {2});
    EXPECT_EQ(progress.text(1.0), "[################--------] 10 of 15 rows, 1 s");
}

TEST(SweepProgress, LongTimesUseMinutesAndHours) {
    EXPECT_EQ(duration_text(119.0), "119 s");
    EXPECT_EQ(duration_text(150.0), "2 min");
    EXPECT_EQ(duration_text(3.0 * 3600.0), "3.0 h");
}

}  // namespace sweep_progress_test
}  // namespace camopt::apps
