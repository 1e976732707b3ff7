// SPDX-License-Identifier: MIT
// Parts of a validated scene file. Errors: InputError for keys that do not fit the type of the motion or the
// follower, missing dimensions, unknown laws, units that do not fit the lift. Internal to input/.
#pragma once

#include "input/document/known_names.hpp"
#include "input/document/scene_source.hpp"
#include "scene/scene.hpp"

namespace camopt::input {

/// A parsed document → validated Scene: checks keys, values and their relations; throws InputError for the
/// first fault.
[[nodiscard]] Scene read_document(const SceneSource& source, const KnownNames& known);

/// [motion]
[[nodiscard]] MotionSpec read_motion(const SceneSource& source, const KnownNames& known);

/// Complete; none if the scene has no cam.
[[nodiscard]] std::optional<CamSpec> read_cam(const SceneSource& source, const MotionSpec& motion,
                                              const KnownNames& known);

[[nodiscard]] std::optional<ForceSpec> read_forces(const SceneSource& source, const Scene& scene);

/// Adds to the limits on the peaks.
void read_cam_limits(const SceneSource& source, const Scene& scene, LimitSpec& limits);

}  // namespace camopt::input
