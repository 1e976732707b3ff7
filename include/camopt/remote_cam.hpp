// SPDX-License-Identifier: MIT
// Disk cams whose roller lever moves the output through a linkage: positions, pressure angle and radii by
// closed forms, dyad by dyad, from the output back to the cam. m, rad.
#pragma once

#include "core/language.hpp"
#include "profiles/remote/remote_cam.hpp"
