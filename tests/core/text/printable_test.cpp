// SPDX-License-Identifier: MIT
// What a terminal would obey is written out; everything else stays.
#include "core/text/printable.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace printable_test {

TEST(Printable, WritesOutWhatTerminalsObey) {
    EXPECT_EQ(printable("a\x1b[31mred"), "a\\u001b[31mred");
    EXPECT_EQ(printable(std::string_view("\0\x07\x7f", 3)), "\\u0000\\u0007\\u007f");
    EXPECT_EQ(printable("1\n2\t3\r"), "1\\u000a2\\u00093\\u000d");
    EXPECT_EQ(printable_lines("1\n2\t3\r"), "1\n2\t3\\u000d");
    EXPECT_EQ(printable("\u0080\u009b\u00a0"), "\\u0080\\u009b\u00a0");
    EXPECT_EQ(printable("\u200d\u200e\u2027\u2028\u202e\u202f\u2066\u2069\u206a"),
              "\u200d\\u200e\u2027\\u2028\\u202e\u202f\\u2066\\u2069\u206a");
}

TEST(Printable, LeavesWordsOfAllLanguages) {
    for (const char* const words :
         {"", "plain words, 1.5 mm", "Kurvenscheibe für Öl: ρ ≥ 3 µm", "凸轮 🙂", "\\u001b"})
        EXPECT_EQ(printable(words), words);
}

TEST(Printable, BytesThatAreNoUtf8) {
    EXPECT_EQ(printable("\x9b"
                        "31m"),
              "\\x9b31m");                                    // a C1 control as one byte
    EXPECT_EQ(printable("\xc3"), "\\xc3");                    // cut off
    EXPECT_EQ(printable("\xc0\x9b"), "\\xc0\\x9b");           // longer than it need be
    EXPECT_EQ(printable("\xe0\x82\x9b"), "\\xe0\\x82\\x9b");  // the same
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half a pair
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
    EXPECT_EQ(printable("\xff"
                        "a"),
              "\\xffa");
}

TEST(Printable, ForXml) {
    EXPECT_EQ(xml_text("<a b=\"c\">&\x1b"), "&lt;a b=&quot;c&quot;&gt;&amp;\\u001b");
}

TEST(AsciiText, TransliteratesLettersAndSigns) {
    EXPECT_EQ(ascii_text("Größe 50 % – ø"), "Groesse 50 % - oe");
    EXPECT_EQ(ascii_text("Ångström, çà, 3 µm, 30°, ½, “x” ≤ ž\n\x1b"),
              "Angstroem, ca, 3 um, 30 deg, 1/2, \"x\" <= z  ");
    EXPECT_EQ(ascii_text("凸\xff\u00a0\u00ff"), "?? y");
}

}  // namespace printable_test
}  // namespace camopt
