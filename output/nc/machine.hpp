// SPDX-License-Identifier: MIT
// Machine tools as pure kinematics: from the pose of the cutter in the cam to the values of the axes, and
// back.
//
// Machine frame: right-handed, the spindle points along −Z. The cam is clamped on a table whose rotary axes
// pass the origin of the cam frame, so height over it along the tool, −O · tip, is Z plus a constant. Axis
// values are those of the formulas; letters, signs and offsets of a control are the post-processor's
// (post_processor.hpp). m and rad. The checks of rapids (nc_travel.hpp) rest on both sentences.
#pragma once

#include "output/nc/cutter_location.hpp"

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace camopt {

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
