// SPDX-License-Identifier: MIT
// The motion of a cam that exists (measured.use = "given"): a smoothing spline through the rows of its
// follower's motion (splines/fitted_curve.hpp), of a cam of lines and arcs one for each stretch between their
// joints. Nothing is optimized: limits that it violates are findings.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// What the spline is of the rows; its motion has one part for each segment of the scene. Peaks and objective
/// are those of the solution. Throws SceneError "measured" for rows that do not determine it.
[[nodiscard]] MeasuredReport given_motion(const Scene& scene);

/// A validated scene whose motion is given, as solved: the motion, its cam, every limit. Verdict: feasible,
/// for the reason given_cam; failed where the cam of the motion cannot be built.
[[nodiscard]] Solution given_solution(const Scene& scene);

}  // namespace camopt
