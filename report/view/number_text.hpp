// SPDX-License-Identifier: MIT
// Numbers as text: exact for machines, short for people. None of them depends on the locale.
#pragma once

#include "core/text/printable.hpp"

namespace camopt {

/// In place of a figure of a cam that its follower cannot touch as designed.
inline constexpr const char* no_contact_words = "undercut, no contact";

/// The shortest decimal text that reads back as the same double. Empty for a value that is not finite.
[[nodiscard]] std::string round_trip_text(double value);

/// The number as people read it, everywhere: `digits` significant digits, without trailing zeros behind the
/// point; no power of ten from 1e-4 to 1e7: "134150", "2.5e7", "1.6e-6". "∞" or "–" for what is not finite.
/// numberText of page/assets/base.js writes the same.
[[nodiscard]] std::string short_text(double value, int digits = 6);
/// "–" for none.
[[nodiscard]] std::string short_text(const std::optional<double>& value);

/// The same with a power of ten from 10^digits on: "2e6" on an axis. Finite.
[[nodiscard]] std::string power_text(double value, int digits);

/// Relative change in percent, signed: "−2.6 %". "–" where it does not exist.
[[nodiscard]] std::string change_text(double value, double reference);

/// A key in words: "modified_sine" becomes "modified sine".
[[nodiscard]] std::string words_of(std::string_view key);

// A table of words and numbers, written for a terminal or as Markdown.
//
// Widths are counted in characters, not bytes: "∞" and "y″" stay in their columns. Rows may be shorter than
// the columns. Nothing throws.

struct TextTable {
    struct Column {
        std::string title;
        bool left = false;  ///< words stand left, numbers right
        bool code = false;  ///< in Markdown, else words
    };
    std::vector<Column> columns;
    std::vector<std::vector<std::string>> rows;
    std::vector<std::string> folders = {};  ///< of the rows: where their first cells lead
};

/// Columns two spaces apart, a rule under the titles, each line ended by a line feed.
[[nodiscard]] std::string aligned_text(const TextTable& table);

/// First cells lead to report.md of the folders.
[[nodiscard]] std::string markdown_text(const TextTable& table);

/// `printable` for Markdown, on one line: nothing in it is a tag, a link, a picture, code or emphasis.
[[nodiscard]] std::string markdown_words(std::string_view text);

/// `printable` as code in Markdown, also where it has backticks.
[[nodiscard]] std::string markdown_code(std::string_view text);

/// `decimals` digits after the point; "∞" where infinite, "–" where there is none.
[[nodiscard]] std::string fixed_text(const std::optional<double>& value, int decimals);

/// The words broken into lines of at most `width` characters; the first starts with `lead`, the others are
/// indented as far.
[[nodiscard]] std::string wrapped_text(const std::string& words, const std::string& lead, int width);

}  // namespace camopt
