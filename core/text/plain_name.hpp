// SPDX-License-Identifier: MIT
// What a program may call things of its own, so that scene files and reports can name them.
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
