// SPDX-License-Identifier: MIT
// TOML scene file → validated Scene: units converted to SI and radians, every value checked, nothing guessed.
// Errors: InputError "FILE:LINE:COLUMN: key: found …; allowed: …", the first one found (keys and values in
// the order of the file, then their relations). The keys are listed in input/keys/scene_keys.hpp and
// docs/scene_file.md.
#pragma once

#include "input/known_names.hpp"
#include "scene/scene.hpp"

#include <filesystem>

namespace camopt::input {

/// `overrides`: "KEY=VALUE" with a dotted key and a TOML value (a bare word is a string), applied before
/// validation; each replaces the key and its synonyms, a later one an earlier one. Errors about it begin with
/// "--set KEY=VALUE: ".
[[nodiscard]] Scene read_scene_file(const std::filesystem::path& path, const KnownNames& known,
                                    std::span<const std::string> overrides = {});

/// The text for read_scene_file; throws InputError if it cannot be read.
[[nodiscard]] std::string scene_file_text(const std::filesystem::path& path);

/// The same, with the tables of the scene (measured.table) written into it: a self-contained text.
[[nodiscard]] std::string whole_scene_text(const std::filesystem::path& path);

/// `source_name` replaces FILE.
[[nodiscard]] Scene read_scene(std::string_view toml, std::string_view source_name, const KnownNames& known,
                               std::span<const std::string> overrides = {});

/// A scene's text, its name in messages, and the settings applied to it.
struct SceneOrigin {
    std::string_view toml, name;
    std::span<const std::string> overrides;
};

/// For a fault found after a scene was read: throws InputError "FILE:LINE:COLUMN: key: what". `member`: of
/// the Scene, "motion.segments[1].law", or a table, "cam".
[[noreturn]] void fail_in_scene(const SceneOrigin& origin, std::string_view member, std::string_view what);

/// The scene as one text without overrides: read_scene of it is the same Scene, bit for bit. Without
/// overrides it is the original text with comments; with overrides, or if the text contains control
/// characters, it is rewritten and its first line says so. Throws InputError for text that is not TOML and
/// for invalid overrides; keys and values are not validated. `folder`: of the scene; a table it names there
/// is written into the text, which is then self-contained.
[[nodiscard]] std::string scene_with_overrides(std::string_view toml, std::string_view source_name,
                                               std::span<const std::string> overrides,
                                               const std::optional<std::filesystem::path>& folder = {});

// Every follower of a scene, with the keys of its dimensions: for lists and tests.
struct FollowerKind {
    std::string cam_type;   ///< "disk", "remote", …: cam.type
    std::string chosen_by;  ///< "cam.follower", "linkage.type"; empty: by cam.type alone
    std::string word;     ///< the value of that key: "translating_roller", "lever", "rotating"; else cam.type
    bool swings = false;  ///< its lift is an angle
    std::string touches_with;  ///< "a roller"
    /// Its dimensions as keys in their first unit: "base_radius_mm" of [cam], "linkage.coupler_mm" of
    /// another.
    std::vector<std::string> keys;
};

/// In the order of the manual.
[[nodiscard]] std::vector<FollowerKind> follower_kinds();

}  // namespace camopt::input
