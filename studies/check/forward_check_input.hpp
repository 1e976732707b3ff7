// SPDX-License-Identifier: MIT
// What a forward check is given about a cam that camopt has designed: the points it exports, and nothing of
// how it made them.
//
// A disk cam is run by its follower. Where a lever carries the roller, profile points only -> lever ->
// output: the lever is put down on the points as the arm of a disk cam (forward_check.hpp), which it is after
// a turn and perhaps a mirror; its angle goes forwards through the linkage by positions alone.
#pragma once

#include "profiles/sampling.hpp"
#include "scene/cam_mechanism.hpp"
#include "studies/check/forward_check.hpp"
#include "studies/delivered/driven_mechanism.hpp"

namespace camopt {

/// About `points` points evenly by cam angle, the motion's breakpoints among them. Closed where the motion
/// takes a whole turn and the cam ends where it began. Of a linkage the deviation is that of the output, m or
/// rad; relative: by the lift. Keeps a reference to the motion. Throws InputError for a mechanism that is
/// neither a disk cam nor has such a lever.
[[nodiscard]] ForwardCheckInput forward_check_input(const DrivenMechanism& mechanism, const Motion& motion,
                                                    const MotionScale& scale, int points = 2000);

struct CheckedSide {
    int side = 0, points = 2000;
    double roller_radius = 0.0;  ///< m
};

/// The same for one side of a disk cam that drives both ways (profiles/disk/disk_sides.hpp), with a roller of
/// this radius whose centre is designed to move as the cam's own does: in a groove one that fills it makes
/// the deviation that of the flank alone. Of the second disk everything is in its mirror: s is −s.
[[nodiscard]] ForwardCheckInput side_check_input(const DrivenMechanism& mechanism, const Motion& motion,
                                                 const MotionScale& scale, const CheckedSide& side);

}  // namespace camopt
