// SPDX-License-Identifier: MIT
// Names in scene files, reports and error messages: of choices, of what users define, and of what a
// misspelled word may have meant.
#pragma once

#include "core/base/standard.hpp"

#include <initializer_list>
#include <variant>

namespace camopt {

/// Dwell-rise-dwell, rise-return, or a program of segments.
enum class MotionType { drd, rr, program };

/// What the entries of a design vector are (splines/design_vector.hpp).
enum class DesignKind { automatic, ordinates, coefficients, states };

/// A value of a backend's own option.
using OptionValue = std::variant<bool, long long, double, std::string>;

[[nodiscard]] const char* name_of(MotionType value);
[[nodiscard]] const char* name_of(DesignKind value);

/// The first of the choices with this name, as name_of gives it; none where no choice has it.
template <class Choice>
[[nodiscard]] std::optional<Choice> choice_named(std::string_view name,
                                                 std::initializer_list<Choice> choices) {
    for (const Choice choice : choices)
        if (name == name_of(choice)) return choice;
    return {};
}

/// A name of a user-defined object: lower case letters, digits and _, at least one.
[[nodiscard]] inline bool is_plain_name(std::string_view name) {
    return !name.empty() && std::ranges::all_of(name, [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || letter == '_';
    });
}

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
