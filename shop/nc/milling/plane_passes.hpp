// SPDX-License-Identifier: MIT
// The passes that mill a plane cam: rings of roughing from the blank's edge inwards, layer by layer, then the
// contour.
//
//   ring j: tip = P + (T_D / 2 + λ_j) n,  λ_j = stock + allowance + j (d − allowance) / count
// d: the farthest that the blank stands off the contour, so that no ring cuts wider than the step-over beside
// smooth contours. Where a ring's offset crosses itself, in hollows, what lies nearer to the cam is left out.
// A ring that is clear of the blank where the contour is farthest from the cam's axis is cut in runs that
// reach the blank, each a pass from clear to clear. Every other pass begins and ends at that place: there the
// whole cam lies behind the tangent. In: a line from beside the blank against the contour, a quarter of a
// circle of radius R that touches the path; out the same way. The tool goes clockwise around the cam where it
// climbs and the spindle turns clockwise. m, rad; frame of ToolPose, the cam's upper face at z = 0.
#pragma once

#include "shop/nc/milling/milling_choice.hpp"

namespace camopt {

struct PlaneMilling {
    PlaneContour contour;       ///< closed
    std::vector<double> knots;  ///< as in block_angles
    PlaneCutter cutter;         ///< stock: what finishing leaves
    Blank blank;
    double safe_distance = 0.0;    ///< m, > 0: passes begin and end so far beside the blank
    double chord_tolerance = 0.0;  ///< m, > 0
    FinishedCam* cam = nullptr;    ///< of the contour; must live as long as the passes
    MillingChoice choice;
};

/// Throws InputError for numbers that are not valid.
[[nodiscard]] MillingPasses plane_passes(const PlaneMilling& milling);

}  // namespace camopt
