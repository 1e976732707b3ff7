// SPDX-License-Identifier: MIT
// A scene file together with everything this camopt knows by name.
#pragma once

#include "core/scene.hpp"

#include <string>
#include <vector>

namespace camopt::apps {

/// Throws InputError for whatever is wrong with the file or the settings (KEY=VALUE).
[[nodiscard]] Scene load_scene(const std::string& file, const std::vector<std::string>& settings);

}  // namespace camopt::apps
