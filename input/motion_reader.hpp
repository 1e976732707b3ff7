// SPDX-License-Identifier: MIT
// [motion] of a validated scene file → MotionSpec. Errors: InputError for keys that do not fit the type of
// the motion, unknown laws, units that do not fit the lift. Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "input/scene_reader.hpp"
#include "scene/scene.hpp"

namespace camopt::input {

[[nodiscard]] MotionSpec read_motion(const SceneSource& source, const KnownNames& known);

}  // namespace camopt::input
