// SPDX-License-Identifier: MIT
// Several limits that have to give way together.
//
// All are relaxed by one common part r, the least that does: upper limits times 1 + r, lower ones divided by
// it. First r doubles, then bisection. Of these, limits that may stay as they are at that r do so. The values
// are rounded away from the edge and the scene with all of them is solved.
#pragma once

#include "studies/delivered/solution.hpp"
#include "studies/explain/adjustment.hpp"
#include "studies/explain/relaxation_budget.hpp"

#include <vector>

namespace camopt {

/// Empty where no common part does, or the time does not reach. A member that has no room (a least radius of
/// 0) stays as it is.
[[nodiscard]] std::vector<Relaxation> joint_relaxation(const Scene& scene,
                                                       const std::vector<Adjustment>& members,
                                                       const Budget& budget);

}  // namespace camopt
