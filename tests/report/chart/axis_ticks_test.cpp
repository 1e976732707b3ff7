// SPDX-License-Identifier: MIT
// Ticks tell themselves from their neighbours, and what is level is drawn level.
#include "report/chart/svg_canvas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace camopt {
namespace axis_ticks_test {

TEST(AxisTicks, NoTwoHaveOneText) {
    for (const double middle : {1.6096, 41.097, 1234567.8, -0.002, 0.0})
        for (const double width : {1e-9, 1e-6, 1e-3, 1.0, 1e4}) {
            const double size = width * std::max(std::abs(middle), 1e-3);
            std::set<std::string> texts;
            const std::vector<PlotTick> ticks = labelled_ticks(middle - size, middle + size, 5);
            for (const PlotTick& tick : ticks) texts.insert(tick.words);
            EXPECT_GE(ticks.size(), 2u);
            EXPECT_EQ(texts.size(), ticks.size()) << middle << " ± " << size << ": " << *texts.begin();
        }
}

TEST(ValueRange, RoundOffCountsAsLevel) {
    ValueRange level;
    for (const double value : {1.6096, 1.6096 + 1e-9, 1.6096 - 1e-9}) level.add(value);
    const ValueRange shown = level.padded(0.06);
    EXPECT_NEAR(shown.upper - shown.lower, 1.12e-3 * 1.6096, 1e-6);
    EXPECT_NEAR(0.5 * (shown.upper + shown.lower), 1.6096, 1e-8);
    ValueRange wide;
    for (const double value : {1.0, 3.0}) wide.add(value);
    EXPECT_DOUBLE_EQ(wide.padded(0.06).lower, 0.88);
    EXPECT_DOUBLE_EQ(wide.padded(0.06).upper, 3.12);
    ValueRange nothing;
    nothing.add(0.0);
    EXPECT_LT(nothing.padded(0.06).lower, 0.0);
}

}  // namespace axis_ticks_test
}  // namespace camopt
