// SPDX-License-Identifier: MIT
// camopt list keys: every key of a scene file, from the table that the reader checks against.
#pragma once

#include "output/json/json_text.hpp"

#include <string>

namespace camopt::apps {

[[nodiscard]] std::string keys_text();

/// An array, one entry a row of the table in its order: table, name, keys as they may be written with their
/// units, type, allowed, choices, default, meaning, needs ("cam", "forces" or null), cam_types (null: all),
/// instead_of (a key or null).
[[nodiscard]] Json keys_json();

}  // namespace camopt::apps
