// SPDX-License-Identifier: MIT
// A scene goes in; the best motion comes out, with its exact peaks and the proof that it is the best.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// Throws InputError for a wrong scene, UnavailableError for a backend this build leaves out. Every numerical
/// outcome is a verdict in Solution::certificate.
[[nodiscard]] Solution solve(const Scene& scene, const SolveControl& control = {});

/// Searches where the problem is not convex, or its breakpoints are free, and the scene does not say how
/// many.
inline constexpr int default_starts = 8;

/// What solve() would run and why.
struct BackendChoice {
    std::string solver;
    std::string reason;  ///< empty where the scene names the solver itself
    DesignKind design = DesignKind::states;
};
[[nodiscard]] BackendChoice choose_backend(const Scene& scene);

}  // namespace camopt
