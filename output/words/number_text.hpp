// SPDX-License-Identifier: MIT
// Numbers as text: exact for machines, short for people. None of them depends on the locale.
#pragma once

#include <string>
#include <string_view>

namespace camopt {

/// In place of a figure of a cam that its follower cannot touch as designed.
inline constexpr const char* no_contact_words = "undercut, no contact";

/// The shortest decimal text that reads back as the same double. Empty for a value that is not finite.
[[nodiscard]] std::string round_trip_text(double value);

/// `digits` significant digits, without trailing zeros behind the point; no power of ten below 1e7: "134150",
/// not "1.3415e+05". "∞" or "–" for what is not finite.
[[nodiscard]] std::string short_text(double value, int digits = 6);

/// Relative change in percent, signed: "−2.6 %". "–" where it does not exist.
[[nodiscard]] std::string change_text(double value, double reference);

/// A key in words: "modified_sine" becomes "modified sine".
[[nodiscard]] std::string words_of(std::string_view key);

}  // namespace camopt
