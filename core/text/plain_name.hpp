// SPDX-License-Identifier: MIT
// Names of user-defined objects, as scene files and reports write them.
#pragma once

#include <algorithm>
#include <string_view>

namespace camopt {

/// Lower case letters, digits and _, at least one.
[[nodiscard]] inline bool is_plain_name(std::string_view name) {
    return !name.empty() && std::ranges::all_of(name, [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '_';
    });
}

}  // namespace camopt
