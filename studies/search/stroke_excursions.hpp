// SPDX-License-Identifier: MIT
// Whether a motion leaves the ranges of its strokes (motion.within_lift, motion.monotone;
// objectives/strokes.hpp).
#pragma once

#include "objectives/strokes.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// The segments at whose begin a motion passes a turning point at speed, with free strokes in the direction
/// given or else taken. It may leave their range by no more than the tolerance δ, but the speed there is
/// √(2 |y''| δ), which may gain 1e-4 of the objective.
[[nodiscard]] std::vector<std::size_t> passed_turning_points(const Scene& scene, const MotionFamily& family,
                                                             const MotionChain& motion,
                                                             std::vector<StrokeDirection> directions = {});

/// Whether the motion leaves the range of a stroke by more than the scene's tolerance.
[[nodiscard]] bool leaves_its_strokes(const Scene& scene, const MotionFamily& family,
                                      const MotionChain& motion);
[[nodiscard]] bool leaves_its_strokes(const Solution& solution);

}  // namespace camopt
