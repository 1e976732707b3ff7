// SPDX-License-Identifier: MIT
// A second opinion on what an elastic follower of one mass makes of a delivered spline, in 113 bits and from
// the pieces of the spline alone (trains/exact_chain.hpp).
//
// Known here: one mass without a return spring, at one speed, a motion of one spline.
#pragma once

#include "benchmarks/trains/exact_chain.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt::stability {

struct TrainAudit {
    double residual = 0.0;     ///< lifts; 0: damped above critical
    double least_force = 0.0;  ///< N, over the motion, at 64 places a piece: no less than the truth
};

/// Throws InputError for a train or a motion that is not known here.
[[nodiscard]] TrainAudit train_audit(const Solution& solution);

}  // namespace camopt::stability
