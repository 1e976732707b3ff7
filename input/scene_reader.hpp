// SPDX-License-Identifier: MIT
// TOML scene file → validated Scene: units converted to SI and radians, every value checked, nothing guessed.
// Errors: InputError "FILE:LINE:COLUMN: key: found …; allowed: …", the first one met (keys and values in the
// order of the file, then what must hold between them). The keys are listed in input/keys/scene_keys.hpp and
// docs/scene_file.md.
#pragma once

#include "scene/cam_mechanism.hpp"
#include "scene/scene.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace camopt::input {

/// The names a scene may refer to. "auto" is always a solver; a law or solver that is not listed is refused.
struct KnownNames {
    std::vector<std::string> laws, solvers;
    /// Of the laws those whose ends move: no reference, and in programs only between splines.
    std::vector<std::string> moving_laws = {};
    /// The folder whose tables (measured.table) a scene may read; none: a scene given as text reads no files.
    std::optional<std::filesystem::path> folder = {};
    /// Makes the formulas of a cam (CamSpec::make) of a kind that does not bring its own; none: such a cam is
    /// refused. profiles/factory knows every kind.
    std::function<std::shared_ptr<const CamMechanism>(const CamSpec& spec)> cam_formulas = {};
};

/// `overrides`: "KEY=VALUE" with a dotted key and a TOML value (a bare word is a string), applied before
/// anything is checked; each replaces the key and every other spelling of the same quantity, a later one an
/// earlier one. Errors about it begin with "--set KEY=VALUE: ".
[[nodiscard]] Scene read_scene_file(const std::filesystem::path& path, const KnownNames& known,
                                    std::span<const std::string> overrides = {});

/// What read_scene_file reads; throws InputError where it cannot.
[[nodiscard]] std::string scene_file_text(const std::filesystem::path& path);

/// The same, with the tables written out that the scene names (measured.table): a text that stands alone.
[[nodiscard]] std::string whole_scene_text(const std::filesystem::path& path);

/// `source_name` stands in the place of FILE.
[[nodiscard]] Scene read_scene(std::string_view toml, std::string_view source_name, const KnownNames& known,
                               std::span<const std::string> overrides = {});

/// A scene's text, what it is called in messages, and the settings on top of it.
struct SceneOrigin {
    std::string_view toml, name;
    std::span<const std::string> overrides;
};

/// Of a scene that was read, for what is wrong with it all the same: throws InputError
/// "FILE:LINE:COLUMN: key: what". `member`: of the Scene, "motion.segments[1].law", or a table, "cam".
[[noreturn]] void fail_in_scene(const SceneOrigin& origin, std::string_view member, std::string_view what);

/// The scene as one text without overrides: read_scene of it is the same Scene, bit for bit. Where there are
/// no overrides it is the text as given, comments and all; with some, and where the text holds what a
/// terminal would obey instead of showing, it is written anew and says so in its first line. Throws
/// InputError for text that is no TOML and overrides that do not fit; keys and values are not looked at.
/// `folder`: of the scene; a table it names there is written into the text, so that the text stands alone.
[[nodiscard]] std::string scene_with_overrides(std::string_view toml, std::string_view source_name,
                                               std::span<const std::string> overrides,
                                               const std::optional<std::filesystem::path>& folder = {});

// Every follower a scene can name, with the keys that say its dimensions: for lists and tests.
struct FollowerKind {
    std::string cam_type;   ///< "disk", "remote", …: cam.type
    std::string chosen_by;  ///< "cam.follower", "linkage.type"; empty: by cam.type alone
    std::string word;       ///< what stands there: "translating_roller", "lever", "rotating"; else cam.type
    bool swings = false;    ///< its lift is an angle
    std::string touches_with;  ///< "a roller"
    /// Its dimensions as keys in their first unit: "base_radius_mm" of [cam], "linkage.coupler_mm" of
    /// another.
    std::vector<std::string> keys;
};

/// In the order of the manual.
[[nodiscard]] std::vector<FollowerKind> follower_kinds();

}  // namespace camopt::input
