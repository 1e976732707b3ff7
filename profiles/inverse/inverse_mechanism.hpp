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

#include "profiles/inverse/inverse_feeder.hpp"
#include "scene/cam_mechanism.hpp"

namespace camopt {

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
// body's. It has no outline with a radius (radius_quantity() is none).
// Exact partials by automatic differentiation, by all numbers. Out of reach: NaN.

/// CamSpec::make of such a cam. Throws InputError for a spec of another type.
[[nodiscard]] std::shared_ptr<const CamMechanism> inverse_mechanism(const CamSpec& spec);

/// A scene's cam of this kind with every number at 0, complete.
[[nodiscard]] CamSpec inverse_spec();

/// Its linkage, and its roller in units of the cam angle (rad for s).
[[nodiscard]] FeederLinkage linkage_of(std::span<const double> numbers);
[[nodiscard]] RollerStroke stroke_of(std::span<const double> numbers);

}  // namespace camopt
