// SPDX-License-Identifier: MIT
// guide.svg: the guide of an inverse cam in its body, to scale: both walls, the way of the roller's centre,
// the roller at both ends of the motion, the body's pivot; dimensions and figures beside it. The body's
// frame.
#pragma once

#include "studies/delivered/driven_mechanism.hpp"
#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt {

/// Both walls at the same cam angles.
struct GuideWalls {
    MechanismProfile left, right;
};

[[nodiscard]] std::string guide_svg(const Solution& solution, const GuideWalls& walls);

}  // namespace camopt
