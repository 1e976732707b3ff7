// SPDX-License-Identifier: MIT
// Scene files: TOML in, validated Scene out (input::read_scene_file, input::read_scene), scenes made key by
// key (input::SceneDocument), and every key such a file may have (input::scene_keys) with its type, unit,
// range and default. Files are in the unit of the key, scenes in SI. Errors: InputError "FILE:LINE:COLUMN:
// key: found …; allowed: …".
#pragma once

#include "input/follower_kinds.hpp"
#include "input/keys/scene_keys.hpp"
#include "input/scene_document.hpp"
#include "input/scene_reader.hpp"
