// SPDX-License-Identifier: MIT
// The words of an enum as one table.
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

/// The word of a value of an enum that counts from 0 to `last`, its last value; "unknown" of any other
/// number.
template <auto last, std::size_t count>
[[nodiscard]] constexpr const char* word_of(decltype(last) value, const char* const (&words)[count]) {
    static_assert(count == static_cast<std::size_t>(last) + 1, "one word for each value, in their order");
    return static_cast<std::size_t>(value) < count ? words[static_cast<std::size_t>(value)] : "unknown";
}

}  // namespace camopt
