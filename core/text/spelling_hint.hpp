// SPDX-License-Identifier: MIT
// Suggestions for a misspelled word, for error messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace camopt {

/// The candidates for a misspelled word, nearest first: those within an edit or two (upper and lower case
/// count as the same), else those that contain every part of it ("flat" is a part of "translating_flat";
/// parts end at '_', '.' and '-').
[[nodiscard]] std::vector<std::string> words_like(std::string_view word,
                                                  const std::vector<std::string>& candidates);

/// "; did you mean 'lift_mm'?", "; did you mean 'translating_flat' or 'oscillating_flat'?", or nothing.
[[nodiscard]] std::string did_you_mean(const std::vector<std::string>& words);

/// Both together.
[[nodiscard]] std::string spelling_hint(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace camopt
