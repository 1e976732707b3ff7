// SPDX-License-Identifier: MIT
// Pictures of plane cams, to scale, with their dimensions.
#pragma once

#include "report/view/view.hpp"

namespace camopt {

/// profile.svg, mechanism.svg or guide.svg: what report/drawing/plane_cam.hpp draws of the cam.
///
///   disk     the cam with its follower where the motion begins and, paler, every 60°
///   remote   the cam at cam angle 0 with its linkage there and, thin, at the two ends of the output's motion
///   inverse  the guide in the frame of its body, the roller at both ends of the motion
///
/// With pitch curve, base and prime circle, a mark every 30° of cam angle and the direction of rotation. A
/// cam that is not closed is drawn as the sector it is; stretches that are undercut are red, and said to be.
/// Throws InputError for a solution without such a cam, and for one that cannot be drawn.
[[nodiscard]] std::string cam_svg(const View& view);

}  // namespace camopt
