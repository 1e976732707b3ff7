// SPDX-License-Identifier: MIT
// profile.dxf of a plane mechanism's cam, as arcs within a tolerance (arc_chain.hpp); mm.
//
//   remote   layers CAM, PITCH (roller centre), ROLLER (where the motion begins), AXES; cam frame, the cam's
//            centre at the origin
//   inverse  layers WALLS (both of the slot), PITCH, ROLLER, AXES; frame of the body, its pivot at the origin
#pragma once

#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt {

struct MechanismDxf {
    std::string text;
    int arcs = 0;            ///< of the cam's outline or both walls
    double deviation = 0.0;  ///< m: these from the true curve, along its normal
};

/// Whether the solution has a cam that can be drawn: of a plane mechanism.
[[nodiscard]] bool has_plane_mechanism(const Solution& solution);

/// tolerance: m, > 0. An undercut cam is drawn with its loops, as it is. Throws InputError for a solution
/// without such a cam and a tolerance that is not positive.
[[nodiscard]] MechanismDxf mechanism_dxf(const Solution& solution, double tolerance = 1e-6);

}  // namespace camopt
