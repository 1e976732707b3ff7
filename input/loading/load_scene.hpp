// SPDX-License-Identifier: MIT
// A scene file, or its text, and all that camopt knows by name: laws, solvers, kinds of cams, the program's
// own among them. What comes back can be solved.
#pragma once

#include "input/loading/known_names.hpp"
#include "input/scene_reader.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace camopt {

/// `settings`: "KEY=VALUE" as `--set` takes them, on top of the file. Throws InputError
/// "FILE:LINE:COLUMN: key: found …; allowed: …".
[[nodiscard]] Scene load_scene(const std::filesystem::path& file, std::span<const std::string> settings = {});

/// The same of a text; `name` stands in the place of FILE. It may name a table (measured.table) only where a
/// `folder` to look in is given.
[[nodiscard]] Scene scene_of_toml(std::string_view toml, std::span<const std::string> settings = {},
                                  std::string_view name = "scene",
                                  const std::optional<std::filesystem::path>& folder = {});

}  // namespace camopt
