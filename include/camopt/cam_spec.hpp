// SPDX-License-Identifier: MIT
// The cam of a scene: follower, dimensions (a number or a range each), rotation, mass, springs. m, rad, kg,
// N.
#pragma once

#include "core/language.hpp"
#include "scene/cam_spec.hpp"
