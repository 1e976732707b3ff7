// SPDX-License-Identifier: MIT
// [cam], [forces] and the limits on them, of a validated scene file. Errors: InputError for dimensions that
// the follower does not have or lacks, units of a translating follower on an oscillating one. Internal to
// input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "input/scene_reader.hpp"
#include "scene/scene.hpp"

namespace camopt::input {

/// Complete; none if the scene has no cam.
[[nodiscard]] std::optional<CamSpec> read_cam(const SceneSource& source, const MotionSpec& motion,
                                              const KnownNames& known);

[[nodiscard]] std::optional<ForceSpec> read_forces(const SceneSource& source, const Scene& scene);

/// Adds to the limits on the peaks.
void read_cam_limits(const SceneSource& source, const Scene& scene, LimitSpec& limits);

}  // namespace camopt::input
