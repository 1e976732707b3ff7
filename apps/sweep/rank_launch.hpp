// SPDX-License-Identifier: MIT
// Whether a launcher (mpirun, srun) started this program together with others.
#pragma once

namespace camopt::apps {

struct RankLaunch {
    int rank = 0;  ///< 0 … size − 1
    int size = 1;  ///< 1: no other process
};

/// Reads the environment that Open MPI, PMI (MPICH, Intel MPI) and Slurm give each process.
[[nodiscard]] RankLaunch rank_launch();

}  // namespace camopt::apps
