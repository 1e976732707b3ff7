// SPDX-License-Identifier: MIT
// What a remote follower's mechanism is, apart from its dimensions.
#pragma once

#include "profiles/remote/remote_spec.hpp"

namespace camopt {

struct RemoteLayout {
    RemoteLinkage linkage = RemoteLinkage::lever;
    Rotation rotation = Rotation::counterclockwise;
    PressurePoint pressure_point = PressurePoint::roller_center;
    /// Of the dyads: +1 left of the line from the pivot to the far joint, −1 right of it.
    double lever_branch = 1.0, rocker_branch = 1.0;
    double side = 1.0;  ///< sign of C·t (profiles/remote/remote_cam.hpp)
};

}  // namespace camopt
