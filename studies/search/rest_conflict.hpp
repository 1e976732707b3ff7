// SPDX-License-Identifier: MIT
// A limit that is broken where every motion of the scene rests: at a displacement the scene itself gives,
// with s' = 0. No search can help there, and none is needed to say so.
#pragma once

#include "objectives/rules/model.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

struct RestConflict {
    std::string key;  ///< of the limit
    KnownPoint where;
    double violation = 0.0;  ///< relative to the limit
};

/// The worst one. Only limits that are not convex (the others are proved by duality), know no higher
/// derivative than s' and have no dimension to move.
[[nodiscard]] std::optional<RestConflict> rest_conflict(const CamModel& model, double tolerance);

/// True: the solution is infeasible, and says by which limit and where.
[[nodiscard]] bool report_rest_conflict(Solution& solution, const CamModel& model);

}  // namespace camopt
