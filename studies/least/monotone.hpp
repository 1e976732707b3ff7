// SPDX-License-Identifier: MIT
// In which numbers of a scene that are no limits its limits are monotone.
#pragma once

#include "scene/scene.hpp"

#include <string_view>

namespace camopt {

/// With a smaller value (downward), or a larger one, the scene has fewer motions: each motion of it is one of
/// the scene before.
enum class Tightens { downward, upward };

/// Known, for the limits that the scene has, of
///   * the base radius of a follower that is pushed straight: its pressure angle falls with the radius, and
///     the radius of the cam on a flat face grows with it;
///   * preload and spring rate, where the contact force is the only limit on loads and the follower never is
///     below s = 0: F grows with both;
///   * the speed (only_tightens_with_speed);
///   * tolerances: what holds for every cam within the wider ones holds for those within the narrower ones.
/// None: not known. key: as written, "cam.base_radius_mm".
[[nodiscard]] std::optional<Tightens> tightening_of(const Scene& scene, std::string_view key);

/// Whether limits only tighten as the speed grows: those in time do. Limits on loads, a falling motor torque,
/// viscous friction, lower limits in time and points in time need not.
[[nodiscard]] bool only_tightens_with_speed(const Scene& scene);

/// A corridor or a set point is written in time.
[[nodiscard]] bool has_points_in_time(const MotionSpec& motion);

}  // namespace camopt
