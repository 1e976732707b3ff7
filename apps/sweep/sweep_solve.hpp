// SPDX-License-Identifier: MIT
// The chunks of a sweep solved by worker processes, into its folder.
#pragma once

#include "apps/sweep/worker_pool.hpp"
#include "output/report/sweep_folder.hpp"
#include "studies/sweep/sweep_plan.hpp"

#include <functional>

namespace camopt::apps {

/// A task whose units are chunks, with what a worker does with one and what is left of one that two workers
/// died of: its rows are failed, with the cause of death as the reason. Both write to the folder.
[[nodiscard]] PoolTask chunk_task(const SweepFolder& folder, SweepScenes& scenes);

/// Solves the chunks that are missing in the folder; each is written there by its worker as soon as it is
/// finished. Progress goes to the terminal, if there is one.
[[nodiscard]] PoolOutcome solve_missing_chunks(const SweepFolder& folder, SweepScenes& scenes, int workers,
                                               const std::function<void()>& begin_worker);

}  // namespace camopt::apps
