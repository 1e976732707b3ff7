// SPDX-License-Identifier: MIT
// Cutter location: where a cylindrical end mill stands while it makes the flank that a roller will touch.
//
// A roller of radius r with its axis through C touches the two flanks at D = C + r n and U = C − r n. A
// cutter of diameter T_D that leaves the stock λ has its axis at
//   T = D + S (U − D),  S = (T_D + 2 λ) / (2 · 2r)        (flank +1; flank −1: U and D exchanged)
// and the direction of the roller. With T_D = 2r, λ = 0 it is the roller itself and makes both flanks
// exactly. A smaller one touches at the steered station only: at the others n is another one, and stock
// stays. Source: Gu, Shin, Kang, Chang, equations (11)–(15). Lengths m, frame of ToolPose.
#pragma once

#include <Eigen/Core>

#include <functional>

namespace camopt {

// Where a cutter stands in the cam: the pose that cutter locations, machines and programs share.
//
// Cam frame: fixed to the cam, its axis of rotation is z. Lengths m.
struct ToolPose {
    Eigen::Vector3d tip;   ///< centre of the cutter's end face
    Eigen::Vector3d axis;  ///< unit vector from the spindle to the tip: into the cam
};

/// The pose over the cam angle θ, rad.
using ToolPath = std::function<ToolPose(double theta)>;

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

// The path of an end mill around a plane cam: its axis stands off the contour by its radius and the stock.
//
//   tip = (P + (T_D / 2 + λ) n, bottom),  axis −z
// P a point of the cam, n its outward normal. A cutter larger than a hollow of the cam cuts into it: the
// check (nc_check.hpp) tells. Frame of ToolPose; m.
struct ContourPoint {
    Eigen::Vector2d position;  ///< m
    Eigen::Vector2d normal;    ///< unit, out of the material
};
using PlaneContour = std::function<ContourPoint(double theta)>;

struct PlaneCutter {
    double diameter = 0.0;  ///< m, > 0
    double stock = 0.0;     ///< λ, m, >= 0
    double bottom = 0.0;    ///< z of the tip, m: at or below the cam's underside

    void validate() const;  ///< throws InputError
};

/// Throws InputError for a cutter that is not valid.
[[nodiscard]] ToolPath plane_cutter_path(PlaneContour contour, const PlaneCutter& cutter);

}  // namespace camopt
