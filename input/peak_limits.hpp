// SPDX-License-Identifier: MIT
// Caps of [limits] on normalised peaks. In time: v = (lift·ω/β) V, a = lift (ω/β)² A, j = lift (ω/β)³ J with
// ω in rad/s and β = the unit angle of the motion in rad. Errors: InputError where a speed is missing or the
// unit does not fit the lift. Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "scene/scene.hpp"

namespace camopt::input {

[[nodiscard]] LimitSpec read_peak_limits(const SceneSource& source, const MotionSpec& motion);

}  // namespace camopt::input
