// SPDX-License-Identifier: MIT
// camopt sweep: many solves of one scene, by worker processes, into a folder that can be continued.
#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/sweep/ranks/sweep_ranks.hpp"
#include "apps/sweep/sweep_finish.hpp"
#include "apps/sweep/sweep_job.hpp"
#include "apps/sweep/sweep_solve.hpp"
#include "core/errors.hpp"

#include <thread>

namespace camopt::apps {

namespace {

int worker_count(const SweepRequest& request) {
    if (request.workers) return *request.workers;
    const unsigned cores = std::thread::hardware_concurrency();
    return cores > 0 ? static_cast<int>(cores) : 1;
}

}  // namespace

ExitCode sweep_command(const SweepRequest& request) {
    if (request.out.empty())
        throw InputError("--out is missing: camopt sweep SCENE --out DIR; see camopt sweep --help");
    if (const RankLaunch launch = rank_launch(); launch.size > 1) return sweep_across_ranks(request, launch);
    SweepJob job(request);
    WorkFolder work(request, job);
    const InterruptWatch watch(InterruptWatch::Signals::termination_too);
    const PoolOutcome outcome = solve_missing_chunks(work.folder(), job.scenes(), worker_count(request),
                                                     [&] { work.leave_to_parent(); });
    if (outcome == PoolOutcome::stopped) return tell_interruption(work.folder());
    return finish_sweep(work.folder(), &job.scenes().scene(0), request.units);
}

}  // namespace camopt::apps
