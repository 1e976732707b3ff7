// SPDX-License-Identifier: MIT
// Numbers in texts that programs write: 1234.5 whatever the locale of the process says.
//
// A sign, digits with a point, an exponent; no white space, no hexadecimal; "inf" and "nan" are no numbers.
#pragma once

#include <optional>
#include <string_view>

namespace camopt {

/// The number that the text is; none where it is none, or not as a whole.
[[nodiscard]] std::optional<double> number_in(std::string_view text);

/// The whole number that the text is, as a whole.
[[nodiscard]] std::optional<long long> integer_in(std::string_view text);

/// number_in for texts that camopt brings along. Throws ModelError where it is none.
[[nodiscard]] double required_number(std::string_view text);

}  // namespace camopt
