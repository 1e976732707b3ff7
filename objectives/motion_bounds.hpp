// SPDX-License-Identifier: MIT
// Linear rules on the motion itself: limits of one side, corridors, limits of a motor that follows it, and
// the lost area as a term.
#pragma once

#include "objectives/rules/linear_bound.hpp"
#include "scene/scene.hpp"

namespace camopt {

/// Limits of one side and corridors of the scene. A normalised limit of a program holds for each spline
/// segment (of a prescribed one: each law) as peak_scales measures it.
[[nodiscard]] std::vector<WrittenBound> motion_bounds(const Scene& scene, const MotionFamily& family);
/// Those of scene_family; a scene without any needs no family.
[[nodiscard]] std::vector<WrittenBound> motion_bounds(const Scene& scene);

/// 1 − (1/L) ∫ y dx over all of the motion of length L, y in lifts; exact for splines, of laws to round-off.
[[nodiscard]] double lost_area(const Motion& motion);
/// What objective.area is divided by: the scene's number, or the lost area of the reference law on the
/// strokes of the scene. Throws SceneError where that is not above 0.
[[nodiscard]] double area_reference(const Scene& scene, const MotionFamily& family);

/// The rules of all of these.
void add_motion_bounds(CamModel& model, const Scene& scene);

}  // namespace camopt
