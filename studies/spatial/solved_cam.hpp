// SPDX-License-Identifier: MIT
// The spatial cam of a solved scene: its dimensions, its motion in SI, its forward check.
#pragma once

#include "core/motion.hpp"
#include "profiles/sampling.hpp"
#include "profiles/spatial/follower_motion.hpp"
#include "profiles/spatial/spatial_cam.hpp"
#include "studies/delivered/solution.hpp"

#include <optional>

namespace camopt {

/// The motion must outlive what is returned. Of a cam: its whole_turn (studies/check/check_cam.hpp).
[[nodiscard]] FollowerMotion follower_motion(const Motion& motion, const MotionScale& scale);

/// Whether the scene's cam is a barrel or a cylindrical one.
[[nodiscard]] bool has_spatial_cam(const Solution& solution);

/// Of a solution whose scene has one, with the dimensions that were chosen. Throws InputError for another.
[[nodiscard]] SpatialCam solved_spatial_cam(const Solution& solution);

/// Both flanks at both ends of the roller drive the follower over the whole turn: about `points` (2000)
/// points a section (spatial_forward_check.hpp). The deviation is that of the output, m or rad; relative: by
/// the lift.
[[nodiscard]] ForwardCheckReport check_spatial_cam(const Solution& solution, std::optional<int> points = {});

}  // namespace camopt
