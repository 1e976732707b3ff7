// SPDX-License-Identifier: MIT
#include "output/words/number_text.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace number_text_test {

TEST(ShortText, HasNoPowerOfTenBelowTenMillion) {
    EXPECT_EQ(short_text(134147.4, 5), "134150");
    EXPECT_EQ(short_text(-4639474.0), "−4639470");
    EXPECT_EQ(short_text(999999.6, 6), "1000000");
    EXPECT_EQ(short_text(12.345678), "12.3457");
    EXPECT_EQ(short_text(100000.0, 6), "100000");
    EXPECT_EQ(short_text(0.0), "0");
    EXPECT_EQ(short_text(2.5e7), "2.5e+07");
    EXPECT_EQ(short_text(2.5e-7), "2.5e-07");
}

}  // namespace number_text_test
}  // namespace camopt
