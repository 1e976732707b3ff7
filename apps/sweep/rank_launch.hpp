// SPDX-License-Identifier: MIT
// Whether mpirun started this program, and the way to the other ranks.
#pragma once

#include "apps/sweep/message_passing.hpp"

#include <memory>

namespace camopt::apps {

/// What mpirun says in the environment of every process it starts.
struct RankLaunch {
    int rank = 0;
    int size = 1;  ///< 1: nobody else, as without mpirun
};

/// Reads the environment of OpenMPI's mpirun and, for others, of the process managers PMI and PMIx.
[[nodiscard]] RankLaunch rank_launch();

/// Loads camopt_mpi.so from beside the program or from where it is installed, and starts MPI. Throws
/// InputError, with what to do, where this camopt was built without MPI or the module does not load.
[[nodiscard]] std::unique_ptr<MessagePassing> start_message_passing(const RankLaunch& launch);

}  // namespace camopt::apps
