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

#include "core/base/standard.hpp"

#include <Eigen/Core>

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
    /// The cutter is as large as the roller and leaves nothing: it makes both flanks at once.
    [[nodiscard]] bool makes_both_flanks() const;
};

/// `roller` at the steered station.
[[nodiscard]] ToolPose cutter_pose(const RollerPose& roller, const CutterLocation& location);

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

// Machine tools as pure kinematics: from the pose of the cutter in the cam to the values of the axes, and
// back.
//
// Machine frame: right-handed, the spindle points along −Z. The cam is clamped on a table whose rotary axes
// pass the origin of the cam frame, so height over it along the tool, −O · tip, is Z plus a constant. Axis
// values are those of the formulas; letters, signs and offsets of a control are the post-processor's
// (post_processor.hpp). m and rad. The checks of rapids (nc_travel.hpp) rest on both sentences.

enum class AxisKind { linear, rotary };

struct MachineAxis {
    std::string key;  ///< "x", "y", "z", "rotary", "tilt"
    AxisKind kind = AxisKind::linear;
};

/// Of a component of a unit vector.
struct AxisRange {
    double least = -1.0, most = 1.0;
};

class Machine {
 public:
    virtual ~Machine() = default;

    [[nodiscard]] virtual std::string name() const = 0;
    /// X, Y, Z come first.
    [[nodiscard]] virtual const std::vector<MachineAxis>& axes() const = 0;
    /// One value an axis; rotary ones in (−π, π]. Throws InputError for a pose the machine cannot take.
    [[nodiscard]] virtual Eigen::VectorXd values(const ToolPose& pose) const = 0;
    [[nodiscard]] virtual ToolPose pose(const Eigen::VectorXd& values) const = 0;
    /// O_z, the part of the tool's direction along the cam's axis, over all positions of the table: by
    /// default any, which is never wrong.
    [[nodiscard]] virtual AxisRange tool_along_cam_axis() const { return {}; }

 protected:
    Machine() = default;
    Machine(const Machine&) = default;
    Machine& operator=(const Machine&) = default;
    Machine(Machine&&) = default;
    Machine& operator=(Machine&&) = default;
};

/// `values` with each rotary axis turned by whole turns to within half a turn of `before`.
[[nodiscard]] Eigen::VectorXd nearest_turn(const Machine& machine, Eigen::VectorXd values,
                                           const Eigen::VectorXd& before);

/// Five axes, the table turns and tilts. With t the offset of Z and O the tool axis,
///   rotary = atan2(O_x, O_y),  tilt = atan2(−O_z, O_x sin rotary + O_y cos rotary),
///   (X, Y, Z + t) = R_y(90° − tilt) R_z(rotary − 90°) tip:
///   X =  t_x s0 s1 + t_y c0 s1 + t_z c1,  Y = −t_x c0 + t_y s0,  Z = −t_x s0 c1 − t_y c0 c1 + t_z s1 − t.
/// The published equation for Y has the other sign: its matrix is a mirror image (determinant −1), which no
/// machine can be. Tilt lies in (−90°, 90°); at ±90° (tool along the cam's axis) the turn is undetermined: an
/// InputError. `z_offset`: t, m. The paper does not say what t is: here what is subtracted from Z, a choice.
[[nodiscard]] std::unique_ptr<Machine> table_tilting_machine(double z_offset);

/// Four axes for three-dimensional cams whose roller stands square to the cam's axis. The cam's z lies
/// along machine X, its x along Y, its y along Z, turned by the rotary axis about X:
///   rotary = −90° − atan2(O_y, O_x),  (Y, Z) = R(rotary) (t_x, t_y),  X = t_z.
/// A tool axis that is not square to z within 1e-9 is an InputError.
[[nodiscard]] std::unique_ptr<Machine> rotary_table_machine();

/// Three axes for plane cams: X, Y, Z are the tip's, the tool axis is −z within 1e-9, or an InputError.
[[nodiscard]] std::unique_ptr<Machine> plane_milling_machine();

}  // namespace camopt
