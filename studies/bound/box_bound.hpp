// SPDX-License-Identifier: MIT
// A lower bound of a problem that is not convex, by linear programs alone.
//
// 1. At finitely many cam angles every rule that is not linear is replaced by planes under it
//    (objectives/boxes/rule_over_box.hpp) over boxes of the motion's state there and of the cam's dimensions.
//    Leaving out angles is a relaxation.
// 2. The boxes are tightened: the least and the greatest value of each of their numbers over that relaxation,
//    the cost at most that of a motion at hand, is one linear program each. Smaller boxes, better planes,
//    again.
// 3. Where the bound's own motion breaks a rule between those angles, angles are added.
// 4. Where that stalls, the bound's own motion is looked at where it violates rules most: of the numbers of
//    largest secant error there that is halved whose halves are bounded best (strong branching). The part of
//    the least bound comes first.
//
// Every bound of a linear program is proved from its multipliers (solvers/vertex/vertex_program.hpp).
#pragma once

#include "objectives/grid/cam_problem.hpp"
#include "studies/bound/box_bound_result.hpp"

namespace camopt {

/// `model`: written in coefficients (few variables). `incumbent`: cost of a motion at hand; infinity: none.
/// Rules that look at the motion as a whole are left out. None where the model has no other that is curved
/// and has an enclosure, a variable that nothing bounds, or what a follower train makes of the motion in its
/// cost.
[[nodiscard]] std::optional<BoxBound> bound_over_boxes(const CamModel& model, double incumbent,
                                                       const BoxBoundOptions& options,
                                                       const SolveControl& control);

}  // namespace camopt
