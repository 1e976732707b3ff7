// SPDX-License-Identifier: MIT
// Executes the plan of a scene (plan.hpp), without the explanation of an infeasible one.
#pragma once

#include "studies/search/planned_run.hpp"

namespace camopt {

/// As solve() (studies/solve/solve.hpp), but infeasible scenes are not explained. `known`: of the scene
/// solved before, and then of this one; null: none. A look is not audited.
[[nodiscard]] Solution solve_without_explaining(const Scene& given, const SolveControl& control,
                                                KnownSolutions* known = nullptr,
                                                const PlanOptions& options = {});

/// Reports the motion and the cam of the least common violation in an infeasible solution that has none; not
/// of conditions that contradict, nor of searched angles and breakpoints, nor after the time. Whether it has
/// one now.
bool show_nearest(Solution& solution, const SolveControl& control);

/// The same of a complete scene inside a search: neither validated nor audited.
[[nodiscard]] Solution solve_planned(const Scene& scene, const SolveControl& control,
                                     KnownSolutions* known = nullptr, const PlanOptions& options = {});

}  // namespace camopt
