// SPDX-License-Identifier: MIT
// The mechanism of a scene with a barrel or cylindrical cam. Internal to input/.
#pragma once

#include "core/scene.hpp"
#include "input/scene_source.hpp"

namespace camopt::input {

/// cam.type is "barrel" or "cylindrical". Throws InputError with the place.
[[nodiscard]] MechanismSpec read_spatial(const SceneSource& source, const MotionSpec& motion);

}  // namespace camopt::input
