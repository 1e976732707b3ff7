// SPDX-License-Identifier: MIT
// Cams: their numbers and choices, as their kind describes them. Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "scene/cam_kind.hpp"
#include "scene/scene.hpp"

#include <optional>

namespace camopt::input {

/// Throws InputError if the output swings and the lift is a length, or the reverse.
void check_lift(const SceneSource& source, const CamKind& kind, const CamVariant& variant,
                const MotionSpec& motion);

/// Without formulas.
[[nodiscard]] CamSpec read_mechanism(const SceneSource& source, const CamKind& kind,
                                     const MotionSpec& motion);

// Caps of [limits] on normalised peaks. In time: v = (lift·ω/β) V, a = lift (ω/β)² A, j = lift (ω/β)³ J with
// ω in rad/s and β = the unit angle of the motion in rad. Errors: InputError for a missing speed or a unit
// that does not fit the lift. Internal to input/.
[[nodiscard]] LimitSpec read_peak_limits(const SceneSource& source, const MotionSpec& motion);

// The [dynamics] table. Internal to input/.
[[nodiscard]] std::optional<DynamicsSpec> read_dynamics(const SceneSource& source, const MotionSpec& motion);

}  // namespace camopt::input
