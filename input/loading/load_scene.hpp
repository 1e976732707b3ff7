// SPDX-License-Identifier: MIT
// Loads a scene from a file or a text with all names that camopt knows: laws, solvers, kinds of cams,
// including those added by the program. The result can be solved.
#pragma once

#include "input/loading/known_scene.hpp"

namespace camopt {

// All laws, solvers and kinds of cams, including those added by the program: the names for input::read_scene.

/// All of them.
[[nodiscard]] input::KnownNames known_names();

// Loads a scene from a file or a text with all names that camopt knows: laws, solvers, kinds of cams,
// including those added by the program. The result can be solved.

/// `settings`: "KEY=VALUE" as for `--set`, applied to the file. Throws InputError "FILE:LINE:COLUMN: key:
/// found …; allowed: …".
[[nodiscard]] Scene load_scene(const std::filesystem::path& file, std::span<const std::string> settings = {});

/// The same for a text; `name` replaces FILE. It may name a table (measured.table) only if a `folder` is
/// given.
[[nodiscard]] Scene scene_of_toml(std::string_view toml, std::span<const std::string> settings = {},
                                  std::string_view name = "scene",
                                  const std::optional<std::filesystem::path>& folder = {});

}  // namespace camopt
