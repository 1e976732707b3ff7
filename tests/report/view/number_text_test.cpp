// SPDX-License-Identifier: MIT
#include "report/view/number_text.hpp"

#include "report/chart/svg_canvas.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace number_text_test {

TEST(ShortText, AvoidsExponentsBelowTenMillion) {
    EXPECT_EQ(short_text(134147.4, 5), "134150");
    EXPECT_EQ(short_text(-4639474.0), "−4639470");
    EXPECT_EQ(short_text(999999.6, 6), "1000000");
    EXPECT_EQ(short_text(12.345678), "12.3457");
    EXPECT_EQ(short_text(100000.0, 6), "100000");
    EXPECT_EQ(short_text(0.0), "0");
    EXPECT_EQ(short_text(2.5e7), "2.5e7");
    EXPECT_EQ(short_text(2.5e-7), "2.5e-7");
    EXPECT_EQ(short_text(-2.41732e17), "−2.41732e17");
    EXPECT_EQ(short_text(1e-100), "1e-100");
}

TEST(MarkdownText, ObeysNothingInWords) {
    EXPECT_EQ(markdown_words("Cam 3 <= 4 & more, limits.velocity_mm_s [2].to"),
              "Cam 3 <= 4 & more, limits.velocity_mm_s [2].to");
    EXPECT_EQ(markdown_words("<b>x</b>"), "\\<b>x\\</b>");
    EXPECT_EQ(markdown_words("[a](b) ![c][d]"), "[a\\](b) ![c\\][d]");
    EXPECT_EQ(markdown_words("# a *b* _c_ `d` &lt; \\"), "\\# a \\*b\\* \\_c\\_ \\`d\\` \\&lt; \\\\");
    EXPECT_EQ(markdown_words("a\nb"), "a\\\\u000ab");
}

TEST(MarkdownText, CodeMayHaveBackticks) {
    EXPECT_EQ(markdown_code("a = 1"), "`a = 1`");
    EXPECT_EQ(markdown_code("a ` <b> `` c"), "``` a ` <b> `` c ```");
    TextTable table{{{"key", true, true}, {"words", true}}, {{"x`|y", "p|*q*"}}};
    EXPECT_NE(markdown_text(table).find("| `` x`\\|y `` | p\\|\\*q\\* |"), std::string::npos)
        << markdown_text(table);
}

// One number, one text: an axis writes its large numbers as the tables do.
TEST(ShortText, IsWhatAxesWrite) {
    EXPECT_EQ(power_text(2e6, 3), "2e6");
    EXPECT_EQ(tick_text(2e7, 1e7), short_text(2e7));
    EXPECT_EQ(tick_text(-2e7, 1e7), short_text(-2e7));
    EXPECT_EQ(tick_text(2e-6, 1e-6), short_text(2e-6));
}

TEST(UnitWords, HaveSuperscripts) {
    EXPECT_EQ(unit_words("m/s^2"), "m/s²");
    EXPECT_EQ(unit_words("mm/deg^3"), "mm/deg³");
    EXPECT_EQ(unit_words("um"), "µm");
    EXPECT_EQ(unit_words("lbf in"), "lbf in");
}

}  // namespace number_text_test
}  // namespace camopt
