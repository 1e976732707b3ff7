// SPDX-License-Identifier: MIT
// The cam of a scene, of any kind (type, choices, dimensions, rotation; disk_cam.hpp, remote_cam.hpp,
// spatial_cam.hpp, inverse_cam.hpp make one each), and what its follower carries. m, rad, kg, N.
#pragma once

#include "core/language.hpp"
#include "scene/cam_spec.hpp"
