// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_job.hpp"
#include "core/platform/console.hpp"

#include <fmt/format.h>

#include <chrono>
#include <thread>

namespace camopt::apps {

namespace {

constexpr std::chrono::milliseconds between_looks{100};
/// File systems over a network may show a new file only after a while, and rank 0 may check its rows longer.
constexpr std::chrono::seconds patience_with_rank_zero{60};
/// In which a launcher ends the other ranks, once rank 0 has reported the error that they have too.
constexpr std::chrono::seconds patience_with_launcher{3};

/// Also compares the sweeps: rows of another one are not to stand in the folder.
SweepFolder folder_of_rank_zero(const std::string& path, const SweepIdentity& mine) {
    const auto last = std::chrono::steady_clock::now() + patience_with_rank_zero;
    while (!SweepFolder::holds(path, mine.study)) {
        if (std::chrono::steady_clock::now() > last)
            throw InputError(
                fmt::format("found no sweep in {}, where rank 0 works; allowed: --out on a file "
                            "system that all machines share",
                            path));
        std::this_thread::sleep_for(between_looks);
    }
    SweepFolder folder = SweepFolder::open(path);
    if (const std::string other = difference(folder.identity(), mine); !other.empty())
        throw InputError(
            fmt::format("found another sweep in {}: {}; allowed: the same scene, tables and "
                        "camopt on all machines",
                        path, other));
    return folder;
}

/// False: interrupted.
bool wait_for_others(const SweepFolder& whole) {
    return std::ranges::all_of(whole.missing_chunks(), [&](int chunk) {
        while (!whole.has_chunk(chunk)) {
            if (InterruptWatch::interrupted()) return false;
            std::this_thread::sleep_for(between_looks);
        }
        return true;
    });
}

ExitCode be_rank_zero(const SweepRequest& request, const StoredSweep& sweep, const SweepShard& share,
                      SweepJob& job) {
    WorkFolder work(request, sweep, share);
    const SweepFolder& whole = work.folder();
    {
        const InterruptWatch watch;
        const bool all = solve_missing_chunks(whole.part(share), job, request.workers.value_or(1),
                                              [&] { work.leave_to_parent(); }) == PoolOutcome::finished &&
                         wait_for_others(whole);
        if (!all) return tell_interruption(whole);
    }
    return finish_sweep(whole, job.first_scene(), request.units);
}

ExitCode be_other_rank(const SweepRequest& request, const SweepIdentity& identity, const SweepShard& share,
                       SweepJob& job) {
    const SweepFolder part = folder_of_rank_zero(request.out, identity).part(share);
    (void)part.remove_leftovers();
    const InterruptWatch watch;
    const PoolOutcome outcome = solve_missing_chunks(part, job, request.workers.value_or(1), {});
    return outcome == PoolOutcome::finished ? success : interrupted;
}

}  // namespace

ExitCode sweep_across_ranks(const SweepRequest& request, const RankLaunch& launch) {
    try {
        if (!request.shard.empty())
            throw InputError(fmt::format(
                "--shard {}: found under a launcher with {} ranks, which are the shards; allowed: "
                "one process, or no --shard",
                request.shard, launch.size));
        SweepJob job(request);
        const StoredSweep sweep = checked_sweep(request, job);
        const SweepShard share{launch.rank + 1, launch.size};
        return launch.rank == 0 ? be_rank_zero(request, sweep, share, job)
                                : be_other_rank(request, sweep.identity, share, job);
    } catch (const InputError& error) {
        if (launch.rank == 0) throw;
        std::this_thread::sleep_for(patience_with_launcher);
        throw InputError(fmt::format("rank {}: {}", launch.rank, error.what()));
    }
}

}  // namespace camopt::apps
