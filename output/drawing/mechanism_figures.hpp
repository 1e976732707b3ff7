// SPDX-License-Identifier: MIT
// The picture of a guide, and how many points tables of mechanisms have.
#pragma once

#include "studies/delivered/driven_mechanism.hpp"
#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt {

/// One a tenth of a degree.
[[nodiscard]] int default_profile_points(const Motion& motion, const MotionScale& scale);

// guide.svg: the guide of an inverse cam in its body, to scale: both walls, the path of the roller's centre,
// the roller at both ends of the motion, the body's pivot; dimensions and figures beside it. The body's
// frame.

/// Both walls at the same cam angles.
struct GuideWalls {
    MechanismProfile left, right;
};

[[nodiscard]] std::string guide_svg(const Solution& solution, const GuideWalls& walls);

}  // namespace camopt
