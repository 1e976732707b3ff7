// SPDX-License-Identifier: MIT
// Cam angles at which the follower rests for every motion of the scene: known before any search.
//
// Both ends of a motion (DRD, RR, an open program), the top of RR, via points of velocity 0, and in a program
// both ends of every dwell and of every law that begins or ends at rest. Points inside a spline where s'
// happens to vanish are not included.
#pragma once

#include "scene/scene.hpp"

#include <vector>

namespace camopt {

/// x, ascending, each once. Throws InputError for an unknown law.
[[nodiscard]] std::vector<double> rest_places(const Scene& scene);

}  // namespace camopt
