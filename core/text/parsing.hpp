// SPDX-License-Identifier: MIT
// Numbers in files that programs write, 1234.5, regardless of the locale of the process.
//
// A sign, digits with a point, an exponent; no white space, no hexadecimal; "inf" and "nan" are not numbers.
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

/// The number that the whole text represents; nullopt otherwise.
[[nodiscard]] std::optional<double> number_in(std::string_view text);

/// The integer that the whole text represents.
[[nodiscard]] std::optional<long long> integer_in(std::string_view text);

/// number_in for built-in texts. Throws ModelError if it is not a number.
[[nodiscard]] double required_number(std::string_view text);

// Texts without surrounding blanks, and their parts between separators: views into the argument.

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
