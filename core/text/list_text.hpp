// SPDX-License-Identifier: MIT
// Lists in sentences: "a, b and c".
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

/// "a", "a and b", "a, b and c": text(item) of each, before the last of several `last`, else `separator`.
template <class Items, class Text = std::identity>
[[nodiscard]] std::string listed(const Items& items, std::string_view last, const Text& text = {},
                                 std::string_view separator = ", ") {
    std::string list;
    for (std::size_t i = 0; i < std::size(items); ++i) {
        if (i > 0) list += i + 1 < std::size(items) ? separator : last;
        list += std::invoke(text, items[i]);
    }
    return list;
}

/// Adds to a list that may be empty.
inline void append_item(std::string& list, std::string_view item, std::string_view separator = ", ") {
    if (!list.empty()) list += separator;
    list += item;
}

[[nodiscard]] inline std::string in_quotes(std::string_view text) {
    return '"' + std::string(text) + '"';
}

/// The first letter, where it is one of ASCII.
[[nodiscard]] inline std::string capitalised(std::string text) {
    if (!text.empty() && text.front() >= 'a' && text.front() <= 'z')
        text.front() = static_cast<char>(text.front() - 'a' + 'A');
    return text;
}

}  // namespace camopt
