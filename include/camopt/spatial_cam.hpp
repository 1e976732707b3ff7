// SPDX-License-Identifier: MIT
// Barrel and cylindrical cams with a cylindrical roller: the roller's axis, contact on both flanks, pressure
// angle, undercut, and the flanks as grids of points. m, rad.
#pragma once

#include "core/language.hpp"
#include "profiles/spatial/contact.hpp"
#include "profiles/spatial/spatial_cam.hpp"
#include "profiles/spatial/spatial_mechanism.hpp"
#include "scene/flank_grid.hpp"
