// SPDX-License-Identifier: MIT
// The solve for given angles and breakpoints: one convex problem, or relaxations and a search from several
// starts (start_search.hpp).
#pragma once

#include "studies/search/planned_run.hpp"

namespace camopt {

/// The best motion for given angles and breakpoints, with the strokes of the posed scene held or not.
[[nodiscard]] Solution solve_motion(const PlannedRun& run);

}  // namespace camopt
