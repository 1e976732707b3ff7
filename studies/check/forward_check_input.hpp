// SPDX-License-Identifier: MIT
// What a forward check is given about a cam that camopt has designed: the points it exports and its follower
// (CamMechanism::follower), and nothing of how it made them.
//
// profile points only -> follower -> output: where a linkage carries the follower's swing on, it is run
// forwards by positions alone.
#pragma once

#include "studies/check/forward_check.hpp"
#include "studies/delivered/driven_mechanism.hpp"

namespace camopt {

/// About `points` points evenly by cam angle, the motion's breakpoints among them. Closed where the motion
/// takes a whole turn and the cam ends where it began. The deviation is relative to the prime radius (a swing
/// times its arm, with a flat face times the centre distance), of a linkage to the lift. Keeps a reference to
/// the motion. Throws InputError for a mechanism without such a follower.
[[nodiscard]] ForwardCheckInput forward_check_input(const DrivenMechanism& mechanism, const Motion& motion,
                                                    const MotionScale& scale, int points = 2000);

struct CheckedSide {
    int side = 0, points = 2000;
    double roller_radius = 0.0;  ///< m
};

/// The same for one side of a cam that drives both ways, with a roller of this radius whose centre is
/// designed to move as the cam's own does: in a groove one that fills it makes the deviation that of the
/// flank alone. What is found at each angle is kept.
[[nodiscard]] ForwardCheckInput side_check_input(const DrivenMechanism& mechanism, const Motion& motion,
                                                 const MotionScale& scale, const CheckedSide& side);

}  // namespace camopt
