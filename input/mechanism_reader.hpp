// SPDX-License-Identifier: MIT
// Cams behind CamMechanism: their numbers and choices, as their kind describes them. Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "scene/cam_kind.hpp"
#include "scene/scene.hpp"

namespace camopt::input {

/// Throws InputError where the output swings and the lift is a length, or the reverse.
void check_lift(const SceneSource& source, const CamKind& kind, const CamVariant& variant,
                const MotionSpec& motion);

/// None where there is no cam, or a disk cam. Without formulas: profiles/factory brings them.
[[nodiscard]] std::optional<MechanismSpec> read_mechanism(const SceneSource& source,
                                                          const MotionSpec& motion);

}  // namespace camopt::input
