// SPDX-License-Identifier: MIT
// Where a cutter stands in the cam: the pose that cutter locations, machines and programs share.
//
// Cam frame: fixed to the cam, its axis of rotation is z. Lengths m.
#pragma once

#include <Eigen/Core>

#include <functional>

namespace camopt {

struct ToolPose {
    Eigen::Vector3d tip;   ///< centre of the cutter's end face
    Eigen::Vector3d axis;  ///< unit vector from the spindle to the tip: into the cam
};

/// The pose over the cam angle θ, rad.
using ToolPath = std::function<ToolPose(double theta)>;

}  // namespace camopt
