// SPDX-License-Identifier: MIT
// One backend on one scene, timed: the call on a given grid, the exchange, or the whole library solve.
// Problems are made before the watch starts, but for the whole solve, which makes its own.
#pragma once

#include "benchmarks/linear/final_grid.hpp"
#include "benchmarks/parts/paired_runs.hpp"
#include "benchmarks/parts/solver_variants.hpp"

namespace camopt::benchmarks {

struct BackendTask {
    SolverVariant variant;
    double tolerance = 1e-9;
    double max_seconds = 60.0;
};

[[nodiscard]] RunOutcome run_call(const CamProblem& problem, const BackendTask& task);
/// Over states, from the first grid and the problem's own start.
[[nodiscard]] RunOutcome run_exchange(const Scene& scene, const BackendTask& task);
/// solve_without_explaining: starting point, exchange, repair and proof. `status` is the verdict.
[[nodiscard]] RunOutcome run_solve(Scene scene, const BackendTask& task);

/// Short runs are repeated for some milliseconds and their median is taken: a first run finds cold caches.
[[nodiscard]] RunOutcome steadied(const std::function<RunOutcome()>& once);

}  // namespace camopt::benchmarks
