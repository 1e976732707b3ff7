// SPDX-License-Identifier: MIT
// A limit that is broken where every motion of the scene rests: at a displacement the scene itself gives,
// with s' = 0. No search can help there, and none is needed to say so.
#pragma once

#include "objectives/model.hpp"
#include "studies/solution.hpp"

namespace camopt {

/// Only limits that are not convex (the others are proved by duality), know no higher derivative than s' and
/// have no dimension to move. True: the solution is infeasible, and says by which limit and where.
[[nodiscard]] bool report_rest_conflict(Solution& solution, const CamModel& model);

}  // namespace camopt
