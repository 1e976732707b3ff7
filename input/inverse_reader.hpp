// SPDX-License-Identifier: MIT
// The mechanism of a scene with an inverse cam. Internal to input/.
#pragma once

#include "input/scene_source.hpp"
#include "scene/scene.hpp"

namespace camopt::input {

/// cam.type is "inverse". Throws InputError with the place.
[[nodiscard]] MechanismSpec read_inverse(const SceneSource& source, const MotionSpec& motion);

}  // namespace camopt::input
