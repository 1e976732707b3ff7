// SPDX-License-Identifier: MIT
// The [dynamics] table. Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "scene/scene.hpp"

#include <optional>

namespace camopt::input {

[[nodiscard]] std::optional<DynamicsSpec> read_dynamics(const SceneSource& source, const MotionSpec& motion);

}  // namespace camopt::input
