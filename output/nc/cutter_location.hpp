// SPDX-License-Identifier: MIT
// Cutter location: where a cylindrical end mill stands while it makes the flank that a roller will touch.
//
// A roller of radius r with its axis through C touches the two flanks at D = C + r n and U = C − r n. A
// cutter of diameter T_D that leaves the stock λ has its axis at
//   T = D + S (U − D),  S = (T_D + 2 λ) / (2 · 2r)        (flank +1; flank −1: U and D exchanged)
// and the direction of the roller. With T_D = 2r, λ = 0 it is the roller itself and makes both flanks
// exactly. A smaller one touches at the steered station only: at the others n is another one, and stock
// stays. Source: Gu, Shin, Kang, Chang, equations (11)–(15). Lengths m, frame of tool_pose.hpp.
#pragma once

#include "output/nc/tool_pose.hpp"

#include <functional>

namespace camopt {

/// The roller of a follower, seen from the cam.
struct RollerPose {
    Eigen::Vector3d center;  ///< of the roller's section at the station
    Eigen::Vector3d axis;    ///< unit vector along the roller, into the cam
    Eigen::Vector3d normal;  ///< unit vector from the centre to the contact with flank +1
};

/// The roller over the cam angle, rad, and the station along its axis, m (growing into the cam).
using RollerPath = std::function<RollerPose(double theta, double station)>;

struct CutterLocation {
    double roller_radius = 0.0;  ///< m, > 0
    double diameter = 0.0;       ///< m, > 0; diameter / 2 + stock <= roller radius
    double stock = 0.0;          ///< λ, m, >= 0: what is left for the next pass
    int flank = 1;               ///< +1 or −1: the one that is cut
    double station = 0.0;        ///< m: where along the roller the cutter is steered
    double tip_beyond = 0.0;     ///< m, >= 0: from the station to the tip

    void validate() const;  ///< throws InputError
};

/// `roller` at the steered station.
[[nodiscard]] ToolPose cutter_pose(const RollerPose& roller, const CutterLocation& location);

/// The cutter over the cam angle. Throws InputError for a location that is not valid.
[[nodiscard]] ToolPath cutter_path(RollerPath roller, const CutterLocation& location);

}  // namespace camopt
