// SPDX-License-Identifier: MIT
#include "apps/studio/studio_controls.hpp"

#include <gtest/gtest.h>

namespace camopt::apps {
namespace slider_range_test {

void expect_range(const SliderRange& slider, double from, double to, double step) {
    EXPECT_DOUBLE_EQ(slider.from, from);
    EXPECT_DOUBLE_EQ(slider.to, to);
    EXPECT_DOUBLE_EQ(slider.step, step);
}

TEST(SliderRange, ReachesTwiceTheValueRoundedUp) {
    expect_range(slider_range(ranges::not_negative, 0.4, false), 0.0, 1.0, 0.005);
    expect_range(slider_range(ranges::any, 40.0, false), 0.0, 100.0, 0.5);
    expect_range(slider_range(ranges::any, 0.0, false), 0.0, 1.0, 0.005);
    expect_range(slider_range(ranges::any, 100.0, false), 0.0, 200.0, 1.0);
}

TEST(SliderRange, NegativeValueReachesBothDirections) {
    expect_range(slider_range(ranges::any, -5.0, false), -10.0, 10.0, 0.1);
}

TEST(SliderRange, KeepsWithinWhatIsAllowed) {
    expect_range(slider_range(Range::above_up_to(0.0, 360.0), 80.0, false), 1.0, 360.0, 1.0);
    const SliderRange open = slider_range({0.0, 90.0, false, false}, 30.0, false);
    EXPECT_GT(open.from, 0.0);
    EXPECT_LT(open.to, 90.0);
    expect_range(slider_range(ranges::positive, 0.4, false), 0.005, 1.0, 0.005);
}

TEST(SliderRange, ManyDecadesStayNearValue) {
    expect_range(slider_range(Range::between(1, 65536), 12.0, true), 1.0, 51.0, 1.0);
    expect_range(slider_range(Range::between(2, 4), 3.0, true), 2.0, 4.0, 1.0);
}

TEST(SliderRange, HoldsItsValue) {
    for (const double value : {1e-9, 0.003, 0.7, 1.0, 2.5, 999.0, 1e6})
        for (const Range& allowed : {ranges::any, ranges::positive, ranges::not_negative}) {
            const SliderRange slider = slider_range(allowed, value, false);
            EXPECT_LE(slider.from, value);
            EXPECT_GE(slider.to, value);
            EXPECT_LE(slider.step, (slider.to - slider.from) / 150.0);
        }
}

}  // namespace slider_range_test
}  // namespace camopt::apps
