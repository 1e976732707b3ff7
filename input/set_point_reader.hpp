// SPDX-License-Identifier: MIT
// Set points, regions and searched angles of a checked scene file, once the rest of the motion is read.
// Errors: InputError for units that do not fit the lift or need a speed, angles that cannot add up to a turn.
// Internal to input/.
#pragma once

#include "input/document/scene_source.hpp"
#include "scene/scene.hpp"

namespace camopt::input {

/// motion.via, and via of every segment, in units of their stretch.
void read_set_points(const SceneSource& source, MotionSpec& motion);

/// Angles to begin a search with: each the same part of the way from the least to the largest of its range,
/// so that they add up to a turn. Nothing happens without ranges.
void settle_angle_ranges(const SceneSource& source, MotionSpec& motion);

/// In lifts; `key`: as the user wrote it.
[[nodiscard]] double displacement_in_lifts(const SceneSource& source, const Given& given,
                                           const std::string& key, const MotionSpec& motion);

}  // namespace camopt::input
