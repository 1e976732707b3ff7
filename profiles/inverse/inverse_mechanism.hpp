// SPDX-License-Identifier: MIT
// The machine of an inverse cam: the motion of its roller, the linkage from the swinging body to the feeder,
// and the guide that both ask for.
//
// The guide is the path of the roller's centre, fixed to the swinging body. The body turns about the origin;
// the roller's centre moves along the +x axis of the fixed frame at (L, 0). In the body's frame the guide is
// psi(L), the polar angle of its point at the distance L from the pivot, so the body is at theta = -psi(L).
// Source: J.-H. Shin, Y.-H. Choi, C.-S. Rho, Kinematic Analysis and Simulation of an Automatic Feeding
// Mechanism Subjected by a Curvilinear Inverse Cam (I), corrected (docs/papers/000.md).
#pragma once

#include "scene/cam_mechanism.hpp"

namespace camopt {

// The roller's motion along its axis: a stroke of constant acceleration.
//
//   L(t) = position + velocity · (t - reference) + acceleration · (t - reference)² / 2   for begin <= t <=
//   end
// m, s.

struct RollerStroke {
    double begin = 0.0, end = 0.0, reference = 0.0;             ///< s
    double position = 0.0, velocity = 0.0, acceleration = 0.0;  ///< m, m/s, m/s² at the reference
};

struct RollerState {
    double distance = 0.0, velocity = 0.0, acceleration = 0.0;  ///< L, dL/dt, d²L/dt²
};

[[nodiscard]] RollerState state_of(const RollerStroke& stroke, double time);

/// The time within the stroke at which the roller is at `distance`; NaN if it never is. The stroke must not
/// reverse inside; of two times the one inside [begin, end].
[[nodiscard]] double time_at(const RollerStroke& stroke, double distance);

// From the swinging cam over its pin and a slotted rocker to the feeder, and back.
//
//   pin     P = L1 (cos(theta + al0), sin(theta + al0))
//   rocker  phi = angle of P - C, counted on without a step from its value at theta = 0;  L2 = |P - C|
//           phi' = L1 theta' cos(th - phi) / L2,  L2' = L1 theta' sin(phi - th)            (th = theta + al0)
//           phi'' = (L1 theta'² sin(phi - th) + L1 theta'' cos(th - phi) - 2 L2' phi') / L2
//   feeder  Y = Yc + Lx tan phi,  Y' = Lx phi' / cos² phi,  Y'' = Lx (phi'' + 2 phi'² tan phi) / cos² phi
// ' is d/dt. Lengths m, angles rad counterclockwise, time s. The feeder slides along the fixed y axis at
// x = Xc + Lx. Numerical failure is a named fault, never NaN.
// Source: the paper's eqs. 13 to 23, corrected.

struct FeederLinkage {
    double pin_distance = 0.0;               ///< L1 > 0: pin from the body's pivot
    double pin_angle = 0.0;                  ///< al0: of the pin where the body is at theta = 0
    Eigen::Vector2d rocker_pivot{0.0, 0.0};  ///< C
    double feeder_offset = 0.0;              ///< Lx, not 0: feeder's line from the rocker's pivot, along x

    void validate() const;  ///< throws InputError
};

/// Angle of the cam's body with its derivatives by time.
struct BodyMotion {
    double angle = 0.0, velocity = 0.0, acceleration = 0.0;
};

enum class InverseFault {
    none,
    roller_before_guide,  ///< L below the guide's begin
    roller_beyond_guide,  ///< L above its end
    pin_on_rocker_pivot,  ///< L2 = 0
    rocker_along_feeder,  ///< cos phi = 0: the rocker does not meet the feeder's line
    rocker_misses_pin,    ///< backwards: no pin on the rocker's line
    pin_at_dead_point,    ///< backwards: the pin's path is along the rocker
    roller_at_rest        ///< backwards: L' = 0, the guide has no direction
};
[[nodiscard]] std::string_view name_of(InverseFault fault);

struct FeederMotion {
    InverseFault fault = InverseFault::none;
    Eigen::Vector2d pin{0.0, 0.0}, pin_velocity{0.0, 0.0}, pin_acceleration{0.0, 0.0};
    double rocker_angle = 0.0, rocker_velocity = 0.0, rocker_acceleration = 0.0;  ///< phi
    double rocker_reach = 0.0, reach_velocity = 0.0, reach_acceleration = 0.0;    ///< L2
    FollowerState feeder;                                                         ///< Y, dY/dt, d²Y/dt²
};

[[nodiscard]] FeederMotion feeder_motion(const FeederLinkage& linkage, const BodyMotion& body);

/// The body's motion that gives the feeder this motion. Of the two pins on the rocker's line the one on the
/// side of the rocker's pivot, and at the distance from it, that belong to theta = 0.
struct BodyResult {
    InverseFault fault = InverseFault::none;
    BodyMotion body;
};
[[nodiscard]] BodyResult body_motion(const FeederLinkage& linkage, const FollowerState& feeder);

// The guide required for a given motion of the feeder.
//
//   psi = -theta,  psi' = -theta'/L',  psi'' = -(theta'' + psi' L'') / L'²    (psi by L, the rest by time)
// Lengths m, angles rad, time s.

/// psi at a distance, with its derivatives by the distance.
struct PolarNode {
    double distance = 0.0, angle = 0.0, slope = 0.0, bend = 0.0;  ///< L, psi, psi', psi''
};

/// The node of the guide for this motion of the feeder and that of the roller.
struct GuideNode {
    InverseFault fault = InverseFault::none;
    PolarNode node;
};
[[nodiscard]] GuideNode wanted_guide(const FeederLinkage& linkage, const RollerState& roller,
                                     const FollowerState& feeder);

// An inverse cam and its feeder as the mechanism of a scene: the feeder's lift is the output, the guide is
// the cam.
//
// The roller starts from rest and moves with a constant acceleration to the end of its stroke; at cam angle 0
// of the scene, where the rise begins, it is at roller_from:
//   L(θ) = rest + u²,  u = sqrt(from − rest) + sqrt(end − rest) θ / roller_angle
// The feeder is at Y = feeder_start + s. Backwards through the linkage follow body
// and guide:
//   pressure_numerator   −L θ_body'    pressure_denominator  L'        ' by the cam angle θ
//   pitch_curvature      ±κ of the guide, regularity 1 ∓ r κ
// Stations: the left and the right wall of the slot, seen along the guide outwards. Frame of the cam: the
// body's. Not drawn by the pictures of disk cams (planar() is false).
// Exact partials by automatic differentiation, by all numbers. Out of reach: NaN.

/// CamSpec::make of such a cam. Throws InputError for a spec of another type.
[[nodiscard]] std::shared_ptr<const CamMechanism> inverse_mechanism(const CamSpec& spec);

/// A scene's cam of this kind with every number at 0, complete.
[[nodiscard]] CamSpec inverse_spec();

/// Its linkage, and its roller in units of the cam angle (rad for s).
[[nodiscard]] FeederLinkage linkage_of(std::span<const double> numbers);
[[nodiscard]] RollerStroke stroke_of(std::span<const double> numbers);

}  // namespace camopt
