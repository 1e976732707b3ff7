// SPDX-License-Identifier: MIT
// A table of words and numbers, written for a terminal or as Markdown.
//
// Widths are counted in characters, not bytes: "∞" and "y″" stay in their columns. Rows may be shorter than
// the columns. Nothing throws.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace camopt {

struct TextTable {
    struct Column {
        std::string title;
        bool left = false;  ///< words stand left, numbers right
    };
    std::vector<Column> columns;
    std::vector<std::vector<std::string>> rows;
};

/// Columns two spaces apart, a rule under the titles, each line ended by a line feed.
[[nodiscard]] std::string aligned_text(const TextTable& table);

[[nodiscard]] std::string markdown_text(const TextTable& table);

/// `decimals` digits after the point; "∞" where infinite, "–" where there is none.
[[nodiscard]] std::string fixed_text(const std::optional<double>& value, int decimals);

/// The words broken into lines of at most `width` characters; the first starts with `lead`, the others are
/// indented as far.
[[nodiscard]] std::string wrapped_text(const std::string& words, const std::string& lead, int width);

}  // namespace camopt
