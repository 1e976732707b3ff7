// SPDX-License-Identifier: MIT
// The solve for given angles and breakpoints: one convex problem, or relaxations and a search from several
// starts (start_search.hpp).
#pragma once

#include "studies/search/planned_run.hpp"

namespace camopt {

/// The best motion for given angles and breakpoints, with the strokes of the posed scene held or not.
[[nodiscard]] Solution solve_motion(const PlannedRun& run);

/// The same with rules for the strokes of a scene whose objective is near one.
[[nodiscard]] Solution solve_with_strokes(const Scene& scene, const HeldStrokes& strokes,
                                          const SolveControl& control);

}  // namespace camopt
