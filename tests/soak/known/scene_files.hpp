// SPDX-License-Identifier: MIT
// Scenes with a known answer as files.
#pragma once

#include "tests/soak/known/known_scene.hpp"

#include <filesystem>

namespace camopt::soak {

/// Writes FOLDER/NAME.toml, or a machine and its axes into FOLDER/NAME; `remarks` above it. The file to
/// solve.
std::filesystem::path write_scene(const KnownScene& scene, const std::filesystem::path& folder,
                                  const std::string& name, const std::string& remarks);

}  // namespace camopt::soak
