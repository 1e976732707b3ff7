// SPDX-License-Identifier: MIT
// A program of segments as a family of motions: x = cam angle / angle of the first spline segment, y in
// lifts.
#pragma once

#include "scene/scene.hpp"
#include "splines/motion_family.hpp"

namespace camopt {

/// Throws InputError for a law that is not allowed in a program (one without a dwell's end).
[[nodiscard]] MotionFamily program_family(const Scene& scene, DesignKind kind);

}  // namespace camopt
