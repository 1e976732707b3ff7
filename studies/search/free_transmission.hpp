// SPDX-License-Identifier: MIT
// The transmission of a servo axis that has a range: which one is best?
//
// For a given transmission r the scene is an ordinary one, of least objective f(r). τ = r (m a + c v + F) + J
// a / r is convex in the motion for each r but not in both, so f may have several minima: values that divide
// the range evenly by ratio are tried, then the interval around the best is narrowed by golden sections over
// log r. Where no motion exists, the least common violation of the limits takes the place of f. Nothing is
// proved of values in between: the verdict is at most local.
#pragma once

#include "studies/search/planned_run.hpp"

namespace camopt {

/// Each value is a scene without the range, solved by `solve`. The solution's scene has the value that was
/// found.
[[nodiscard]] Solution solve_free_transmission(const Scene& scene, const SolveControl& control,
                                               const SolveScene& solve);

}  // namespace camopt
