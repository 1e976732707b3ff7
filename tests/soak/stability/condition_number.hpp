// SPDX-License-Identifier: MIT
// How well a design vector is conditioned.
//
// Let x be the design entries in the optimizer's units (objectives/grid/cam_problem.hpp), E x = e the rows
// that the form does not build in (continuity of `states`), and the columns of Z an orthonormal basis of E's
// null space. Every admissible motion is x_0 + Z z. Let M_r map x to y^{(r)} at the breakpoints and at the
// middles of the segments, r = 2, 3. The condition number of order r is the ratio of the largest to the least
// singular value of M_r Z: the factor by which a relative error of z may grow on its way to the accelerations
// (jerks) that the peaks are made of. O(n³).
#pragma once

#include "scene/scene.hpp"

namespace camopt::stability {

/// order: 2 or 3; kind: not automatic. Throws InputError where the motion has no freedom.
[[nodiscard]] double condition_number(const Scene& scene, DesignKind kind, int order);

}  // namespace camopt::stability
