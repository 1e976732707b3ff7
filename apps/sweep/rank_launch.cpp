// SPDX-License-Identifier: MIT
#include "apps/sweep/rank_launch.hpp"

#include "core/text/parsing.hpp"

#include <cstdlib>

namespace camopt::apps {

namespace {

struct LauncherVariables {
    const char *rank, *size;
};

// Slurm last: mpirun inside a Slurm job sets its own. SLURM_STEP_NUM_TASKS is set by srun only, not by
// sbatch.
constexpr std::array launchers = {LauncherVariables{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                  LauncherVariables{"PMI_RANK", "PMI_SIZE"},
                                  LauncherVariables{"SLURM_PROCID", "SLURM_STEP_NUM_TASKS"}};

std::optional<int> number_in_environment(const char* name) {
    const char* text = std::getenv(name);
    const std::optional<long long> value = text ? integer_in(text) : std::nullopt;
    if (!value || !std::in_range<int>(*value)) return std::nullopt;
    return static_cast<int>(*value);
}

}  // namespace

RankLaunch rank_launch() {
    for (const LauncherVariables& names : launchers) {
        const std::optional<int> rank = number_in_environment(names.rank);
        const std::optional<int> size = number_in_environment(names.size);
        if (rank && size && *rank >= 0 && *rank < *size) return {*rank, *size};
    }
    return {};
}

}  // namespace camopt::apps
