// SPDX-License-Identifier: MIT
//
// A bound over boxes (branch and bound) as a list of inequalities, each of which follows from earlier ones:
// the content of Certificate::box_proof, and all that a checker needs.
//
// x are the problem's variables, within `box`. Every step is an inequality  weights · x <= side:
//   linear   a row of the scene: a linear rule at a cam angle, a condition, a row on parameters
//   cost     cost · x + constant is at most that of the incumbent: only better motions are considered
//   plane    of a rule that is not linear, at a cam angle: slope · z + constant <= rule (times a positive
//            factor) for z = (y, y', y'', y''', parameters of the rule) in the step's box, so that the rule,
//            where it is satisfied, gives slope · z + constant <= 0. `ends` names the steps that are the
//            ends of that box; −1: the bounds in `box`.
//   derived  with the multipliers λ >= 0 of earlier steps, and x within `box` and `bounds` (steps that
//            bound one variable):  weights · x <= Σ λ_i side_i + Σ_j max(r_j x_j),
//            r = weights − Σ λ_i weights_i; the maximum over x_j between its bounds
//   split    an assumption of one part; the other part has its opposite
// A part ends with the bound that its multipliers give for −cost · x in the same way, or in a contradiction
// (infeasible). The parts are the leaves of a binary tree of splits, so that together they cover everything.
#pragma once

#include "core/numbers/interval.hpp"
#include "solvers/certificate/certificate.hpp"

namespace camopt {

struct BoxStep {
    enum class Kind { linear, cost, plane, derived, split };
    Kind kind = Kind::linear;
    Eigen::VectorXd weights;
    double side = 0.0;
    RowOrigin origin;                                 ///< linear, plane
    std::vector<std::pair<int, double>> multipliers;  ///< derived: of steps
    std::vector<int> bounds;                          ///< derived: steps that bound one variable
    // Of a plane.
    std::vector<Interval> box;             ///< of z
    std::vector<std::array<int, 2>> ends;  ///< of each interval: the steps of its lower and its upper end
    Eigen::VectorXd slope;
    double constant = 0.0;
};
[[nodiscard]] const char* name_of(BoxStep::Kind value);

struct BoxPart {
    std::vector<int> splits;  ///< steps of kind split that it assumes, from the whole inwards
    std::vector<std::pair<int, double>> multipliers;
    std::vector<int> bounds;
    double bound = 0.0;  ///< of cost · x + constant; infeasible: +infinity
    bool infeasible = false;
};

struct BoxProof {
    std::vector<std::string> variables;
    Eigen::VectorXd cost;
    double constant = 0.0;
    Box box;
    std::vector<BoxStep> steps;
    std::vector<BoxPart> parts;
    double bound = 0.0;  ///< the least of the parts' bounds and of the cost of the incumbent
};

/// Without the steps that no part depends on.
[[nodiscard]] BoxProof pruned(const BoxProof& proof);

/// The least of the parts' bounds, each step and part recomputed in long double and rounded outward.
/// +infinity: every part ends in a contradiction. Throws ModelError if a step claims more than it follows
/// from. Does not verify that planes underestimate their rules and that linear rows are those of the scene.
[[nodiscard]] double recomputed_bound(const BoxProof& proof);

}  // namespace camopt
