// SPDX-License-Identifier: MIT
// A scene goes in; the best motion comes out, with its exact peaks and the proof that it is the best.
#pragma once

#include "studies/delivered/solution.hpp"
#include "studies/search/plan.hpp"

namespace camopt {

/// Throws InputError for a wrong scene, UnavailableError for a backend this build leaves out. Every numerical
/// outcome is a verdict in Solution::certificate.
[[nodiscard]] Solution solve(const Scene& scene, const SolveControl& control = {});

}  // namespace camopt
