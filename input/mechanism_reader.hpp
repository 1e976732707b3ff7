// SPDX-License-Identifier: MIT
// Cams that are not of type "disk": their numbers and choices. Internal to input/.
#pragma once

#include "input/scene_source.hpp"
#include "scene/scene.hpp"

namespace camopt::input {

/// None where there is no cam, or a disk cam. Without formulas: profiles/factory brings them.
[[nodiscard]] std::optional<MechanismSpec> read_mechanism(const SceneSource& source,
                                                          const MotionSpec& motion);

}  // namespace camopt::input
