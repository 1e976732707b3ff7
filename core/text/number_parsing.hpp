// SPDX-License-Identifier: MIT
// Numbers in files that programs write, 1234.5, regardless of the locale of the process.
//
// A sign, digits with a point, an exponent; no white space, no hexadecimal; "inf" and "nan" are not numbers.
#pragma once

#include <optional>
#include <string_view>

namespace camopt {

/// The number that the whole text represents; nullopt otherwise.
[[nodiscard]] std::optional<double> number_in(std::string_view text);

/// The integer that the whole text represents.
[[nodiscard]] std::optional<long long> integer_in(std::string_view text);

/// number_in for built-in texts. Throws ModelError if it is not a number.
[[nodiscard]] double required_number(std::string_view text);

}  // namespace camopt
