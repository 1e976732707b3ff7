// SPDX-License-Identifier: MIT
// Lines of roughing at a distance d from a surface of the cam: tip = P(v) + d n(v).
//
// In hollows whose radius of curvature is below d such a line crosses itself: between the two places it is
// nearer to the cam than d, and in the middle of that it runs back. m, frame of ToolPose.
#pragma once

#include "shop/nc/finished_cam.hpp"

namespace camopt {

/// How deep a circle in the plane of the surface stands in the cam, no matter how thick the cam is.
[[nodiscard]] double depth_in_plane(FinishedCam& cam, const Eigen::Vector2d& center, double radius);

/// True where a block of the line may end: it is no nearer to the cam than d, and runs the way of the
/// surface. span: of the whole surface in v. The cam must live as long as the result.
[[nodiscard]] std::function<bool(double v)> ends_of_offset(PlaneContour surface, double d, double span,
                                                           FinishedCam* cam);

}  // namespace camopt
