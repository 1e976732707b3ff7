// SPDX-License-Identifier: MIT
// Diagrams over the cam angle of a mechanism's cam, and how many points they and the tables have.
#pragma once

#include "studies/delivered/driven_mechanism.hpp"
#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt {

/// One a tenth of a degree.
[[nodiscard]] int default_profile_points(const Motion& motion, const MotionScale& scale);

/// The pressure angle, deg, with the scene's limit.
[[nodiscard]] std::string pressure_angle_svg(const Solution& solution, const MechanismProfile& profile);

/// The curvature of the cam, 1/mm, > 0 convex, with the scene's limit.
[[nodiscard]] std::string curvature_svg(const Solution& solution, const MechanismProfile& profile);

// guide.svg: the guide of an inverse cam in its body, to scale: both walls, the path of the roller's centre,
// the roller at both ends of the motion, the body's pivot; dimensions and figures beside it. The body's
// frame.

/// Both walls at the same cam angles.
struct GuideWalls {
    MechanismProfile left, right;
};

[[nodiscard]] std::string guide_svg(const Solution& solution, const GuideWalls& walls);

}  // namespace camopt
