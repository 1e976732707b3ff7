// SPDX-License-Identifier: MIT
// The kinematics of an inverse cam's machine: the roller's stroke, the linkage from the swinging body to the
// feeder and back, and the guide that both ask for. Frames: profiles/inverse/inverse_mechanism.hpp.
#pragma once

#include "profiles/inverse/feeder_linkage.hpp"
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

/// Angle of the cam's body with its derivatives by time.
struct BodyMotion {
    double angle = 0.0, velocity = 0.0, acceleration = 0.0;
};

enum class InverseFault {
    none,
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

}  // namespace camopt
