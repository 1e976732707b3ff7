// SPDX-License-Identifier: MIT
// The mechanism of a scene with a barrel or cylindrical cam. Internal to input/.
#pragma once

#include "input/scene_source.hpp"
#include "scene/scene.hpp"
#include "scene/spatial_spec.hpp"

namespace camopt::input {

/// cam.type is "barrel" or "cylindrical". Throws InputError with the place.
[[nodiscard]] MechanismSpec read_spatial(const SceneSource& source, const MotionSpec& motion);

/// The name of the key in [cam] that says a number of such a cam; empty: none.
[[nodiscard]] std::string spatial_key(SpatialFollower follower, SpatialNumber number);

}  // namespace camopt::input
