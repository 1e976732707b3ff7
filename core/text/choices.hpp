// SPDX-License-Identifier: MIT
// Choices that a scene names and the numerical code knows.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
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

// From a name back to the choice that name_of gives it.

/// The first of the choices with this name; none where no choice has it.
template <class Choice>
[[nodiscard]] std::optional<Choice> choice_named(std::string_view name,
                                                 std::initializer_list<Choice> choices) {
    for (const Choice choice : choices)
        if (name == name_of(choice)) return choice;
    return {};
}

}  // namespace camopt
