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

}  // namespace camopt
