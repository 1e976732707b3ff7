// SPDX-License-Identifier: MIT
// From a name back to the choice that name_of gives it.
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>

namespace camopt {

/// The first of the choices with this name; none where no choice has it.
template <class Choice>
[[nodiscard]] std::optional<Choice> choice_named(std::string_view name,
                                                 std::initializer_list<Choice> choices) {
    for (const Choice choice : choices)
        if (name == name_of(choice)) return choice;
    return {};
}

}  // namespace camopt
