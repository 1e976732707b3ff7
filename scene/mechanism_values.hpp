// SPDX-License-Identifier: MIT
// What goes into a mechanism between a cam and its output, and what comes out of it: states, quantities with
// their partials, boxes and stretches of them, points of the cam, and parts of a drawing. Values only; the
// formulas are a CamMechanism (cam_mechanism.hpp). SI: m, rad, s' and s'' by the cam angle.
#pragma once

#include "core/numbers/enclosures.hpp"
#include "core/partials.hpp"
#include "scene/cam_spec.hpp"

namespace camopt {

class CamMechanism;

/// Quantities in limits. Each is smooth wherever the mechanism moves (a flat face on an arm: and 1 + σψ' ≠
/// 0). Every mechanism has the first two and the regularity; the others if it says so.
enum class MechanismQuantity {
    pressure_numerator,    ///< tan φ = numerator / denominator; m
    pressure_denominator,  ///< > 0 where the mechanism moves; m
    pitch_curvature,       ///< of the roller centre's path, 1/m, > 0 where the cam is convex; planar cams
    cam_radius,            ///< signed radius of the cam, m; followers with a flat face
    regularity,            ///< <= 0: undercut. Planar: 1 − r κ; spatial: g of the flank
    contact_offset,        ///< contact offset of a flat face, m
    normal_lever,  ///< force along the normal = F / lever (pushed: cos φ) or M / lever (swinging, m); loaded
                   ///< cams
    contact_radius  ///< m: R of the Hertz pressure √(N E* / (π b R)); loaded three-dimensional cams
};

/// Throws ModelError: the mechanism does not have the requested quantity.
[[noreturn]] void refuse_quantity(std::string_view mechanism);

/// Value with first and second partials by (s, s', s'', the active dimensions in their order); its sums and
/// products: core/partials.hpp.
struct MechanismValue {
    static constexpr int most_active = 24;  ///< dimensions that may be variable at once
    using Gradient = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3 + most_active, 1>;
    using Hessian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3 + most_active,
                                  3 + most_active>;
    double value = 0.0;
    Gradient gradient;
    Hessian hessian;
    double by_angle = 0.0;  ///< partial by MechanismState::theta; 0 if the input rotates uniformly
};

/// One side of a limit on the pressure angle, at one station.
struct PressureSide {
    double limit = 0.0;  ///< φm, rad
    int sign = 1;
    int station = 0;
};

/// A mechanism whose active dimensions the optimizer varies; the others have these values.
struct MechanismSetting {
    std::span<const double> dimensions;
    std::span<const int> active;
};

/// One state of one mechanism.
struct MechanismState {
    std::span<const double> dimensions;
    FollowerState output;
    double theta = 0.0;  ///< cam angle, rad: for mechanisms whose input does not rotate uniformly (inverse)
};

/// A mechanism over a box: each number a function of the box's variables.
struct MechanismStateOver {
    std::vector<RangeOver> dimensions;
    RangeOver s, velocity, acceleration;
    Interval theta;
};

/// The same along a stretch of a motion, with derivatives by the variable of the motion.
struct MechanismStateAlong {
    std::span<const double> dimensions;
    RangeAlong s, velocity, acceleration;
    RangeAlong theta;
};

/// One point of the cam at one station. Planar: z = 0.
struct MechanismPoint {
    double theta = 0.0;
    Eigen::Vector3d pitch, contact;  ///< roller centre (axis) and a point of the cam's surface, cam frame
    Eigen::Vector3d normal;          ///< outward unit normal of the cam there, cam frame
    double pressure_angle = 0.0;     ///< signed, rad
    double pitch_curvature = 0.0;    ///< 1/m; NaN where the mechanism has none
    double cam_radius = 0.0;         ///< signed, m: > 0 convex, < 0 concave; NaN where it has none
    double regularity = 0.0;
    double contact_offset = 0.0;  ///< m: contact offset of a flat face (profiles/disk/disk_cam.hpp)
    double contact_radius = 0.0;  ///< m: as the quantity; only of a mechanism that has it
};

/// A part of a drawing of the mechanism in the fixed frame, in its plane, m.
struct MechanismShape {
    enum class Kind { link, circle, pivot, guide, face };
    Kind kind = Kind::link;
    std::string name;  ///< "lever", "roller", …
    /// link: its line; guide: the guided point at output 0 and now; circle, pivot: the centre; face: the
    /// origin of contact offsets, and a point 1 m along in their positive direction. Its length is that of
    /// the contact, or given by the scene.
    std::vector<Eigen::Vector2d> points;
    double radius = 0.0;  ///< circle
};

/// Where the cam frame is in the frame that stands still: turned about the cam's centre, then shifted. A cam
/// that rotates uniformly has turned by σθ.
struct CamPose {
    double turn = 0.0;                   ///< rad
    Eigen::Vector2d shift = {0.0, 0.0};  ///< m
};

/// A mechanism with its numbers.
struct DrivenMechanism {
    std::shared_ptr<const CamMechanism> formulas;
    std::vector<double> dimensions;
};

}  // namespace camopt
