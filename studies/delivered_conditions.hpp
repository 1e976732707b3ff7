// SPDX-License-Identifier: MIT
// Whether the delivered splines are the curves they should be: joints as smooth as their space says.
//
// Where breakpoints lie very close (or are very many) y''' is a difference of nearly equal numbers divided by
// the cube of their distance, and rounding alone makes it jump. Peaks and limits of such a curve are those of
// no motion of the space, so no verdict but `failed` is true of it.
#pragma once

#include "studies/solution.hpp"

namespace camopt {

/// A jump of y … y''' that is this much of the derivative's own peak is still the same motion for every
/// purpose.
inline constexpr double largest_joint_jump = 1e-6;

struct JointJump {
    double relative = 0.0;  ///< by the largest magnitude of that derivative
    double at = 0.0;        ///< x
    int order = 0;
};

/// The worst jump of a derivative up to min(continuity, 3) at an interior breakpoint.
[[nodiscard]] JointJump worst_joint_jump(const SplineCurve& curve);

/// The verdict becomes `failed` (reason "breakpoints_too_close", a note says where) where a delivered spline
/// jumps by more than largest_joint_jump. Nothing to do where no motion was delivered.
void judge_delivered_joints(Solution& solution);

}  // namespace camopt
