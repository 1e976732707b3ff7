// SPDX-License-Identifier: MIT
// The parts of find_fault. Each checks one part of a scene whose numbers lie in their ranges, and returns the
// first fault. Internal to core/.
#pragma once

#include "core/text/quantity_text.hpp"
#include "scene/scene.hpp"

namespace camopt {

using Fault = std::optional<SceneFault>;

/// Locations along the motion closer than this coincide; the rounding of a decimal breakpoint is far below.
inline constexpr double same_place = 1e-12;

[[nodiscard]] Fault number_fault(const Scene& scene);         ///< every number against its range
[[nodiscard]] Fault motion_fault(const MotionSpec& motion);   ///< angles, points, members that fit the type
[[nodiscard]] Fault program_fault(const MotionSpec& motion);  ///< segments; type program only
/// A program whose every displacement is free or 0 is solved by a dwell: it prescribes nothing.
[[nodiscard]] Fault idle_fault(const MotionSpec& motion);
[[nodiscard]] Fault set_point_fault(const MotionSpec& motion);  ///< points and regions of all lists
[[nodiscard]] Fault measured_fault(const Scene& scene);         ///< rows, order, lift of a measured motion
[[nodiscard]] Fault cam_fault(const Scene& scene);              ///< its dimensions, members that fit its kind
[[nodiscard]] Fault force_fault(const Scene& scene);
[[nodiscard]] Fault drawing_fault(const Scene& scene);   ///< bore and keyway in the cam
[[nodiscard]] Fault dynamics_fault(const Scene& scene);  ///< the elastic train, and the terms that need one
[[nodiscard]] Fault drive_fault(const Scene& scene);     ///< the motor, and what needs one
[[nodiscard]] Fault limit_fault(const Scene& scene);
[[nodiscard]] Fault limit_unit_fault(const Scene& scene, LimitedFigure figure);  ///< does it fit the lift
[[nodiscard]] Fault own_rules_fault(const Scene& scene);  ///< terms and limits of the program

}  // namespace camopt
