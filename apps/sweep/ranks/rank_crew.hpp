// SPDX-License-Identifier: MIT
// The workers of one rank and the process that leads them.
//
// A process that has started MPI must not fork: so the leader is forked before, runs the same pool of workers
// as a sweep without MPI, and the rank itself only carries messages. A solve that crashes costs its worker,
// not the rank, for whose death mpirun ends the whole run.
#pragma once

#include "apps/commands.hpp"
#include "apps/sweep/ranks/rank_message.hpp"
#include "apps/sweep/worker_process.hpp"

#include <chrono>
#include <optional>

namespace camopt::apps {

class RankCrew {
 public:
    /// Forks the leader, which waits for `tell`({begin}).
    RankCrew(const SweepRequest& request, int rank);

    /// What rank 0 says to this rank: begin, chunk, no_more, stop. After stop nobody is left.
    void tell(const RankMessage& message);
    /// What the leader says: asks, done, gone, wrong_input, error; waits at most so long. After `gone`,
    /// `wrong_input` and `error` nothing comes any more.
    [[nodiscard]] std::optional<RankMessage> listen(std::chrono::microseconds patience);

 private:
    std::optional<WorkerProcess> leader_;
};

}  // namespace camopt::apps
