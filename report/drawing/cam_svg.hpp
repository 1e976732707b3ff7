// SPDX-License-Identifier: MIT
// profile.svg: the cam to scale in the cam frame, with its pitch curve, base and prime circle, its follower
// where the motion begins and, paler, every 60°, a mark every 30° of cam angle, the direction of rotation and
// its dimensions. Stretches that are undercut are red, and said to be.
#pragma once

#include "report/drawing/profile_shape.hpp"

namespace camopt {

/// A shape that is not closed is drawn as the sector it is.
[[nodiscard]] std::string profile_svg(const ProfileShape& shape, std::string_view title);

// Pictures of planar cams that do not touch their follower themselves, to scale.

/// mechanism.svg: the cam and its pitch curve at cam angle 0, roller, levers, couplers and slider there, and
/// thin the links at the two ends of the output's motion; beside it dimensions and figures. The frame that
/// stands still. Throws InputError for a mechanism that cannot be drawn.
[[nodiscard]] std::string mechanism_svg(const View& view);

/// guide.svg: the guide of an inverse cam in its body: both walls at the same cam angles, the path of the
/// roller's centre, the roller at both ends of the motion, the body's pivot; dimensions and figures beside
/// it. The body's frame.
[[nodiscard]] std::string guide_svg(const View& view, const std::vector<DeliveredRow>& left_wall,
                                    const std::vector<DeliveredRow>& right_wall);

}  // namespace camopt
