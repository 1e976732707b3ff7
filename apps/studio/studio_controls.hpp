// SPDX-License-Identifier: MIT
// What of a scene a page can change: its keys and those it could have, from the table that the reader of
// scene files checks against. A key added there is a control here.
#pragma once

#include "scene/key_row.hpp"

#include <nlohmann/json.hpp>

namespace camopt::apps {

/// `text`: a scene that was read without an error. An array in the order of the table, one entry a key:
///
///   table, key   "motion.segments[1]", "angle_deg": with a dot between them as `--set` names it
///   item         "angle": the key without its unit
///   group, name, shown_unit, label   as control_words
///   given        whether the scene says it; value is null where it does not
///   type         "number", "integer", "boolean", "choice", "text", "range" (value: { min, max })
///   value, unit, choices, default, allowed, meaning
///   units        { unit, factor } of every unit a number may be typed in: value = number · factor
///   may_range    a number that may be a range, searched by the optimizer
///   seek         of a limit the key that finds how far it can go, "objective.least"; else empty
///   slider       { from, to, step } of a given number or integer, else null
///
/// Tables and arrays are none. Of keys the scene does not have, those that need a cam or forces it has not,
/// or another type of cam, are left out, and those in whose place another is given.
[[nodiscard]] nlohmann::ordered_json studio_controls(const std::string& text);

// What a control is called: words, no keys.
struct ControlWords {
    std::string group;  ///< of its table: "Motion", "Segment 1", "Set point 2 of segment 1"
    std::string name;   ///< "Largest camshaft torque"; in a list "cam angle"
    std::string unit;   ///< "deg", "mm/s²"; empty: none
    std::string label;  ///< "Segment 1: cam angle, deg", "Largest camshaft torque, N m"
};

/// table: as written, "motion.segments[0]".
[[nodiscard]] ControlWords control_words(std::string_view table, const KeyRow& row, std::string_view unit);

// A unit that a number may be typed in: what the key is written in = number · factor.
struct UnitChoice {
    std::string unit;
    double factor = 1.0;
};

/// Those of the same dimension, the key's own among them: mm, in, m of a length. None of a number without a
/// unit.
[[nodiscard]] std::vector<UnitChoice> units_of_field(const KeyRow& row, const Spelling& written);

/// The same scene written in mm or in inches, with forces, masses and pressures where a key can be written in
/// both; every number to 1e-9. The text as it is where nothing changes. Throws InputError for text that
/// is not TOML.
[[nodiscard]] std::string scene_in_units(const std::string& text, LengthUnit unit);

/// `entry` (a TOML table) as a new one of a list: it stands at `path`, "motion.segments[2]", and what stood
/// there follows it. Throws InputError for a path that leads to no place in a list.
[[nodiscard]] std::string scene_with_entry(const std::string& text, const std::string& path,
                                           const std::string& entry);

// How far a slider goes and how fine: within what a key allows, around where its value stands.
struct SliderRange {
    double from = 0.0, to = 1.0, step = 0.01;
};

/// The whole range where it has two ends. Else from its one end, or from zero (a negative value: from as far
/// on the other side), to twice the value, rounded up to 1, 2 or 5 times a power of ten; of 0 to 1. The step,
/// 1, 2 or 5 times a power of ten, is a two-hundredth of the way or less; 1 of integers. An end that is not
/// allowed itself is left out by one step.
[[nodiscard]] SliderRange slider_range(const Range& allowed, double value, bool integer);

// The values a key of a scene can have, where they can be listed.

/// Laws and solvers by their names, true and false, words; empty where any text or number may stand.
[[nodiscard]] std::vector<std::string> values_of_key(const KeyRow& row);

/// "auto" and every solver this build has.
[[nodiscard]] std::vector<std::string> solver_words();

}  // namespace camopt::apps
