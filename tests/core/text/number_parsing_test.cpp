// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "core/text/parsing.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace number_parsing_test {

TEST(NumberParsing, TakesNumbersAsProgramsWriteThem) {
    EXPECT_EQ(number_in("1234.5"), 1234.5);
    EXPECT_EQ(number_in("-2e-3"), -2e-3);
    EXPECT_EQ(number_in("+3"), 3.0);
    EXPECT_EQ(number_in(".5"), 0.5);
    EXPECT_EQ(number_in("0.1"), 0.1);
    EXPECT_EQ(integer_in("-17"), -17);
    EXPECT_EQ(integer_in("+17"), 17);
}

TEST(NumberParsing, RefusesPartlyNumericText) {
    for (const char* text : {"", "+", "-", "+-1", "1,5", " 1", "1 ", "1.5x", "0x10", "inf", "nan", "-inf",
                             "1e999", "1.2.3", "one"})
        EXPECT_FALSE(number_in(text)) << text;
    for (const char* text : {"", "1.5", "1e3", "99999999999999999999", "x"})
        EXPECT_FALSE(integer_in(text)) << text;
    EXPECT_THROW(static_cast<void>(required_number("1,5")), ModelError);
    EXPECT_EQ(required_number("1.5"), 1.5);
}

}  // namespace number_parsing_test
}  // namespace camopt
