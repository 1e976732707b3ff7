// SPDX-License-Identifier: MIT
// Pictures of planar cams that do not touch their follower themselves, to scale.
#pragma once

#include "output/view/view.hpp"

#include <string>
#include <vector>

namespace camopt {

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
