// SPDX-License-Identifier: MIT
// What of a scene a page can change: its keys and those it could have, from the table that the reader of
// scene files checks against. A key added there is a control here.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

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

}  // namespace camopt::apps
