// SPDX-License-Identifier: MIT
// profile.dxf of a delivered plane cam of any kind, as arcs within a tolerance (arc_chain.hpp); mm.
//
//   disk     profile_dxf.hpp
//   remote   layers CAM, PITCH (roller centre), ROLLER (where the motion begins), AXES; cam frame, the cam's
//            centre at the origin
//   inverse  layers WALLS (both of the slot), PITCH, ROLLER, AXES; frame of the body, its pivot at the origin
#pragma once

#include "output/drawing/dxf/profile_dxf.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// tolerance: m, > 0. An undercut cam is drawn with its loops, as it is. Throws InputError for a solution
/// without such a cam and a tolerance that is not positive.
[[nodiscard]] ProfileDxf cam_dxf(const Solution& solution, double tolerance = 1e-6);

}  // namespace camopt
