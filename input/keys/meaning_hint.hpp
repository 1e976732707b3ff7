// SPDX-License-Identifier: MIT
// Suggestions for terms of other programs: "swing_deg" is lift_deg, a follower "flat" is translating_flat or
// oscillating_flat, a motion "DRDR" is a program. For error messages. Internal to input/.
#pragma once

#include "input/keys/scene_keys.hpp"

namespace camopt::input {

/// The key of the table that a synonym means, with the written unit; empty if none is known. "swing_deg" in
/// "motion" → "lift_deg".
[[nodiscard]] std::string key_meant(std::string_view table, std::string_view written);

/// "; did you mean …?" for a text that is not a choice of a key; empty if nothing is similar. `path`:
/// "motion.type".
[[nodiscard]] std::string choice_hint(std::string_view path, std::string_view text,
                                      const std::vector<std::string>& choices);

}  // namespace camopt::input
