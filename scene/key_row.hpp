// SPDX-License-Identifier: MIT
// One key of a scene file: type, units, range, default, meaning. The rows of the scene itself are in input/,
// those of a kind of cam in its leaf (scene/cam_kind.hpp).
#pragma once

#include "core/numbers/range.hpp"
#include "scene/spellings.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

enum class KeyType {
    text,             ///< a string; one of `choices` if there are any
    boolean,          ///< true or false
    integer,          ///< an integer; one of `choices` where there are any
    number,           ///< a finite number
    number_or_range,  ///< a finite number, or a table of two: { min = …, max = … }
    numbers,          ///< an array of finite numbers
    table,            ///< a table with its own rows
    tables,           ///< an array of such tables
    text_or_table,    ///< a string, or a table with its own rows
    options,          ///< a table of any keys with text, boolean or number values
};

/// How this version treats a key of the contract.
enum class Availability {
    now,
    needs_cam,       ///< only together with a [cam] table
    needs_forces,    ///< only together with a [forces] table
    needs_dynamics,  ///< only together with a [dynamics] table
};

struct KeyRow {
    std::string_view table;  ///< "motion", "objective.reference"; empty: top level
    std::string_view name;   ///< without the unit: "lift"
    KeyType type = KeyType::number;
    std::span<const Spelling> spellings;    ///< never empty; exactly one of them may be written
    Range range;                            ///< of numbers and integers, in the unit of the first spelling
    std::vector<std::string_view> choices;  ///< allowed texts (or integers as text)
    std::string_view default_text;          ///< "required" if there is none
    std::string_view meaning;
    Availability availability = Availability::now;
    std::string_view instead_of = {};  ///< another key of the table that excludes it
    /// Only if cam.type is one of these; empty: for any type. Filled from the kinds of cams.
    std::vector<std::string_view> cam_types = {};

    [[nodiscard]] bool is_for(std::string_view type_of_cam) const;
    /// The types it is for, each between two `quote`s: "disk" or "barrel".
    [[nodiscard]] std::string cam_types_text(char quote) const;
    [[nodiscard]] bool required() const { return default_text == "required"; }
    [[nodiscard]] std::string key(const Spelling& spelling) const;  ///< "lift_mm"
    /// The allowed values in words for an error message, in the unit of the spelling.
    [[nodiscard]] std::string allowed(const Spelling& spelling) const;
    /// The choices as a message lists them: "a", "b" or "c".
    [[nodiscard]] std::string choices_text() const;
};

/// "a", "b" or "c", each in quotes.
[[nodiscard]] std::string quoted_choices(const std::vector<std::string_view>& words);

namespace spellings {

using namespace ranges;

}  // namespace spellings
}  // namespace camopt
