// SPDX-License-Identifier: MIT
// What of a scene a page can change: its keys and those it could have, from the table that the reader of
// scene files checks against. A key added there is a control here.
#pragma once

#include "scene/key_row.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace camopt::apps {

/// `text`: a scene that was read without an error. An array in the order of the table, one entry a key:
///
///   table, key   "motion.segments[1]", "angle_deg": with a dot between them as `--set` names it
///   given        whether the scene says it; value is null where it does not
///   type         "number", "integer", "boolean", "choice", "text", "range" (value: { min, max })
///   value, unit, choices, default, allowed, meaning
///   may_range    a number that may be a range, searched by the optimizer
///   slider       { from, to, step } of a given number or integer, else null
///
/// Tables and arrays are none. Of keys the scene does not have, those that need a cam or forces it has not,
/// or another type of cam, are left out, and those in whose place another is given.
[[nodiscard]] nlohmann::ordered_json studio_controls(const std::string& text);

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
