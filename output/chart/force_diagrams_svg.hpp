// SPDX-License-Identifier: MIT
// forces.svg: what the follower of a disk cam and its contact carry over the cam angle: the force (swinging:
// moment) on the follower, the force along the normal, the torque of the camshaft and the Hertz pressure,
// with their limits dotted and their extremes marked where the report names them. Where the follower cannot
// touch the cam as designed the normal force and the pressure are left out: they do not exist.
#pragma once

#include "core/motion.hpp"
#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt {

/// motion: of the whole cam (cam_motion of studies/check/check_cam.hpp). Throws InputError where the solution
/// has no forces.
[[nodiscard]] std::string force_diagrams_svg(const Solution& solution, const Motion& motion);

}  // namespace camopt
