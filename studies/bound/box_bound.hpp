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
#include "solvers/certificate/box_proof.hpp"

namespace camopt {

struct BoxBoundOptions {
    double gap = 1e-4;       ///< relative: enough
    int places_a_piece = 3;  ///< cam angles on each piece of the motion to begin with, >= 1
    int most_passes = 12;    ///< over all boxes, in one part
    int most_parts = 200;    ///< boxes halved at most
};

struct BoxBound {
    double bound = -infinity;  ///< cost of every motion that keeps the limits is at least this
    bool infeasible = false;   ///< proved: no motion keeps the limits
    std::shared_ptr<const BoxProof> proof;
    Eigen::VectorXd x;  ///< of the bound's own motion, which breaks limits: to begin a search from
    int places = 0, passes = 0, parts = 1;
    long programs = 0, steps = 0;
};

/// `model`: written in coefficients (few variables). `incumbent`: cost of a motion at hand; infinity: none.
/// Rules that look at the motion as a whole are left out. None where the model has no other that is curved
/// and has an enclosure, a variable that nothing bounds, or what a follower train makes of the motion in its
/// cost.
[[nodiscard]] std::optional<BoxBound> bound_over_boxes(const CamModel& model, double incumbent,
                                                       const BoxBoundOptions& options,
                                                       const SolveControl& control);

}  // namespace camopt
