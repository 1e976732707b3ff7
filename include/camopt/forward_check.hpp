// SPDX-License-Identifier: MIT
// The finished cam turned under its follower, by its points alone: does the follower move as designed?
// checked_cam(solution) for a solved scene with a cam of any kind, forward_check(input) for points of any
// origin. m, rad.
#pragma once

#include "core/language.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/check/forward_check.hpp"
#include "studies/checked/checked_cam.hpp"
