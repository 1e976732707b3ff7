// SPDX-License-Identifier: MIT
// A TOML file whose keys are described by rows (scene/key_row.hpp) → the object that they are stored in.
#pragma once

#include "input/keys/scene_keys.hpp"

namespace camopt::input {

/// Keys that the text lacks keep the value of `owner`. Throws InputError "NAME:LINE:COLUMN: key: found …;
/// allowed: …" for text that is not TOML and for the first fault of a key or value; `owner` is then changed
/// in part.
void read_key_file(std::string_view toml, std::string_view name, KeyRows rows, const KeyOwner& owner);

/// A key, "cutter_mm", and its value as `--set` takes it; texts need no quotes.
using KeySetting = std::pair<std::string, std::string>;

/// Such keys of the first table. Throws InputError "KEY: found …; allowed: …" for the first fault.
void read_keys(std::span<const KeySetting> settings, KeyRows rows, const KeyOwner& owner);

}  // namespace camopt::input
