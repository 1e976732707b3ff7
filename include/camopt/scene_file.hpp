// SPDX-License-Identifier: MIT
// Scene files: TOML in, Scene out, ready to be solved: load_scene(file), scene_of_toml(text). Behind them the
// reader itself (input::read_scene_file, input::read_scene), scenes made key by key (input::SceneDocument),
// and every key such a file may have (input::scene_keys) with its type, unit, range and default. Files are in
// the unit of the key, scenes in SI. Errors: InputError "FILE:LINE:COLUMN: key: found …; allowed: …".
#pragma once

#include "core/language.hpp"
#include "input/keys/scene_keys.hpp"
#include "input/loading/load_scene.hpp"
#include "input/scene_document.hpp"
#include "input/scene_reader.hpp"
