// SPDX-License-Identifier: MIT
// The roller of a three-dimensional cam as the NC programs want it (output/nc/cutter_location.hpp).
#pragma once

#include "output/nc/cutter_location.hpp"
#include "profiles/spatial/follower_motion.hpp"
#include "profiles/spatial/spatial_cam.hpp"

namespace camopt {

/// Stations are heights h along the roller; flank +1 is σ_f = +1, the D of paper 001.
[[nodiscard]] RollerPath roller_path(const SpatialCam& cam, const FollowerMotion& motion);

}  // namespace camopt
