// SPDX-License-Identifier: MIT
// What a bound over boxes (studies/bound/box_bound.hpp) is asked for, and what it found.
#pragma once

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

}  // namespace camopt
