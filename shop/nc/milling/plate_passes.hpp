// SPDX-License-Identifier: MIT
// The passes that mill the surface of a plate that slides: lines of roughing above it, layer by layer, then
// the surface itself, from beyond one end of the plate to beyond the other.
//
//   line j: tip = P + (T_D / 2 + λ_j) n,  λ_j = stock + allowance + j (d − allowance) / count
// d: the farthest that the blank's upper side stands off the surface. Beyond either end the path goes on
// along the tangent there, until the cutter is clear of the blank. Where the offset of a line crosses itself,
// in hollows, what lies nearer to the plate is left out; where it is clear of the blank, the line is cut in
// runs. Sides and bottom of the plate are made before. m, rad; frame of ToolPose: x along the plate, y up
// from its bottom, the face at z = 0.
#pragma once

#include "shop/nc/milling/milling_choice.hpp"

namespace camopt {

struct PlateMilling {
    PlaneContour surface;          ///< from the first knot to the last; its body is below
    std::vector<double> knots;     ///< as in block_angles
    PlaneCutter cutter;            ///< stock: what finishing leaves
    Blank blank;                   ///< a block
    double safe_distance = 0.0;    ///< m, > 0: passes begin and end so far beside the blank
    double chord_tolerance = 0.0;  ///< m, > 0
    FinishedCam* cam = nullptr;    ///< of the plate; must live as long as the passes
    MillingChoice choice;
};

/// Throws InputError for numbers that are not valid.
[[nodiscard]] MillingPasses plate_passes(const PlateMilling& milling);

}  // namespace camopt
