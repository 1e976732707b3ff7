// SPDX-License-Identifier: MIT
// An inverse cam and its feeder as the mechanism of a scene: the feeder's lift is the output, the guide is
// the cam.
//
// The roller starts from rest and moves with a constant acceleration to the end of its stroke; at cam angle 0
// of the scene, where the rise begins, it is at roller_from:
//   L(θ) = rest + u²,  u = sqrt(from − rest) + sqrt(end − rest) θ / roller_angle
// The feeder is at Y = feeder_start + s. Backwards through the linkage (inverse_feeder.hpp) follow body and
// guide:
//   pressure_numerator   −L θ_body'    pressure_denominator  L'        ' by the cam angle θ
//   pitch_curvature      ±κ of the guide, regularity 1 ∓ r κ
// Stations: the left and the right wall of the slot, seen along the guide outwards. Frame of the cam: that of
// profiles/inverse/guide.hpp. Not drawn by the pictures of disk cams (planar() is false).
// Exact partials by automatic differentiation, by all numbers. Out of reach: NaN.
#pragma once

#include "profiles/inverse/inverse_feeder.hpp"
#include "scene/cam_mechanism.hpp"
#include "scene/cam_spec.hpp"

#include <memory>
#include <span>

namespace camopt {

/// CamSpec::make of such a cam. Throws InputError for a spec of another type.
[[nodiscard]] std::shared_ptr<const CamMechanism> inverse_mechanism(const CamSpec& spec);

/// A scene's cam of this kind with every number at 0, complete.
[[nodiscard]] CamSpec inverse_spec();

/// Its linkage, and its roller in units of the cam angle (rad for s).
[[nodiscard]] FeederLinkage linkage_of(std::span<const double> numbers);
[[nodiscard]] RollerStroke stroke_of(std::span<const double> numbers);

}  // namespace camopt
