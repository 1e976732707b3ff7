// SPDX-License-Identifier: MIT
// Disk cams: scene.cam = disk_spec({.follower = …}) puts one into a scene. One point of the follower's motion
// makes one point of the cam (profile_point), and the quantities that limits are made of (pressure angle,
// radii, forces) with exact partials. Frames and signs stand in the header this one brings; m, rad, s' in
// m/rad. disk_cam(solution.cam->cam) is the one that was delivered.
#pragma once

#include "core/language.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "profiles/disk/disk_mechanism.hpp"
