// SPDX-License-Identifier: MIT
// Texts without surrounding blanks, and their parts between separators: views into the argument.
#pragma once

#include <string_view>
#include <vector>

namespace camopt {

/// Without the characters of `blanks` at both ends.
[[nodiscard]] inline std::string_view trimmed(std::string_view text, std::string_view blanks = " \t\r\n") {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Each part trimmed: one more than there are separators, so an empty text has one empty part.
[[nodiscard]] inline std::vector<std::string_view> split_text(std::string_view text, char separator,
                                                              std::string_view blanks = " \t\r\n") {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(separator);
        parts.push_back(trimmed(text.substr(0, end), blanks));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

}  // namespace camopt
