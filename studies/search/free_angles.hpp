// SPDX-License-Identifier: MIT
// Programs whose segments have a range for their angle: which angles, that still add up to the turn, are
// best?
//
// For given angles β the scene is an ordinary one, of least objective f(β). Boxes [l, u] of angles are
// bounded and split, the one of the least bound first, where a bound is known:
//
//   Each segment's y over its own part u = (θ − start) / β of the way. Where every spline rests at both of
//   its ends nothing but the limits in time knows β: |y^{(r)}(u)| lift (ω / β)^r <= cap, which a larger β
//   only loosens, and V, A, J are normalised by β. So f falls, or stays, where an angle grows, and on a box
//   f(β) >= f(u'), u' the largest angles in it that leave the others their least (they need not add up).
//
// Within `solver.gap` of the least bound the verdict is optimal (proof: boxes). Otherwise, and where no bound
// is known (cams with limits, joints at speed, set points in units), angle is passed from one segment to
// another by steps that shrink until none helps: local with two ranges, feasible with more.
#pragma once

#include "studies/search/planned_run.hpp"

namespace camopt {

/// Each set of angles is a scene without ranges, solved by `solve`; its angles need not add up to a
/// turn. The solution's scene has the angles that were found.
[[nodiscard]] Solution solve_free_angles(const Scene& scene, const SolvePlan& plan,
                                         const SolveControl& control, const SolveScene& solve);

}  // namespace camopt
