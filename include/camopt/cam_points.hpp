// SPDX-License-Identifier: MIT
// A whole cam as points: sampled_profile(cam, motion, scale, sampling), with s = lift · y and θ = unit_angle
// · x. Points are placed closer where the cam bends. m, rad.
#pragma once

#include "core/language.hpp"
#include "profiles/sampling.hpp"
