// SPDX-License-Identifier: MIT
// The column beside the drawing of a cam: what the lines mean, the dimensions, and what is wrong.
#pragma once

#include "output/chart/svg_canvas.hpp"
#include "output/drawing/profile_shape.hpp"

#include <string_view>

namespace camopt {

struct ProfileLegend {
    double left = 0.0, top = 0.0;  ///< px
    bool undercut = false;
};

/// CSS rules: heading.
[[nodiscard]] std::string_view profile_legend_style();
void draw_profile_legend(SvgCanvas& canvas, const ProfileShape& shape, const ProfileLegend& legend);

}  // namespace camopt
