// SPDX-License-Identifier: MIT
// Linear (plate, wedge) cams: a plate slides under a roller or an edge that is pushed along a line or carried
// by an arm.
//
// Frame of the cam: x along the travel, y = 0 the plate's bottom, x = 0 below the roller's centre where the
// motion begins. At the cam angle θ it has moved by (−c θ, 0), c = travel/2π: the plate slides towards −x
// where the travel is positive. With the height h of the surface at displacement 0 the roller's centre is at
//   pushed   (c θ + s sin δ, h + r + s cos δ)                    δ the inclination of its path
//   on an arm, pivot at (l cos ψ₀, p) in the frame that stands still, ψ = ψ₀ + s, h + r = p + l sin ψ₀
//            (c θ + l (cos ψ₀ − cos ψ), p + l sin ψ)
// and the material lies below its path. The pressure angle of a pushed roller is linear in s':
//   tan φ = (s' + c sin δ)/(|c| cos δ),   κ = −|c| cos δ s''/(c² + 2 c s' sin δ + s'²)^(3/2), > 0 convex,
// the limit of a disk cam whose base radius grows while the arc of its rise stays the same. Pushed by a flat
// face there is none: between two bodies that only slide a face keeps its direction, and lines of one
// direction envelop nothing but a wedge of that slope.
// Compared with disk cams of growing radius in tests/profiles/linear.
#pragma once

#include "profiles/linear/linear_spec.hpp"
#include "scene/cam_mechanism.hpp"

namespace camopt {

/// CamSpec::make of such a cam. Throws InputError for a spec of another type and an unknown follower.
[[nodiscard]] std::shared_ptr<const CamMechanism> linear_mechanism(const CamSpec& spec);

/// A scene's cam of this kind with every number at 0, complete.
[[nodiscard]] CamSpec linear_spec(PlateFollower follower);

}  // namespace camopt
