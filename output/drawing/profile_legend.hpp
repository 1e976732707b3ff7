// SPDX-License-Identifier: MIT
// The column beside the drawing of a cam: what the lines mean, the dimensions, and what is wrong.
#pragma once

#include "output/chart/svg_canvas.hpp"
#include "output/drawing/profile_shape.hpp"

namespace camopt {

void draw_profile_legend(SvgCanvas& canvas, const ProfileShape& shape, bool undercut);

}  // namespace camopt
