// SPDX-License-Identifier: MIT
// The workshop drawing of a plate that slides: its outline with the path of the roller's centre, the view
// from its end, dimensions, a table of points.
//
// The model is the plate's frame: x along the travel, x = 0 below the roller's centre where the motion begins
// (the datum), y from the bottom. The table gives for cam angles from the beginning of the motion to its end
// the point of the surface that the follower touches, x and y, and the centre of its roller, xc and yc.
// Sheet, scale and lines as in cam_sheet.hpp.
#pragma once

#include "report/drawing/profile_shape.hpp"
#include "shop/sheet/sheet.hpp"

namespace camopt {

/// drawing: of drawing_of, with a thickness. volume: of the plate, m³, for its mass. Throws InputError for a
/// plate too large for any sheet.
[[nodiscard]] Sheet plate_sheet(const Solution& solution, const ProfileShape& shape,
                                const DrawingSpec& drawing, double volume);

}  // namespace camopt
