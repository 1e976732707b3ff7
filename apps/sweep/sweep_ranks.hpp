// SPDX-License-Identifier: MIT
// camopt sweep under mpirun: one sweep by all ranks, into one folder that they share.
#pragma once

#include "apps/commands.hpp"
#include "apps/sweep/rank_launch.hpp"

namespace camopt::apps {

/// Rank 0 checks the rows, makes the folder, hands out the missing chunks one by one to whoever is free, and
/// writes the table; every rank solves with --workers workers, 1 where it is not said, and writes what it
/// finished. What the other ranks return is success. Throws InputError as a sweep without MPI does, from rank
/// 0.
[[nodiscard]] ExitCode sweep_across_ranks(const SweepRequest& request, const RankLaunch& launch);

}  // namespace camopt::apps
