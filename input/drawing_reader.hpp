// SPDX-License-Identifier: MIT
// The [drawing] table. Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "scene/drawing_spec.hpp"

#include <optional>

namespace camopt::input {

[[nodiscard]] std::optional<DrawingSpec> read_drawing(const SceneSource& source);

}  // namespace camopt::input
