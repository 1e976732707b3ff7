// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_job.hpp"
#include "apps/terminal.hpp"
#include "report/folders/result_folder.hpp"

#include <fmt/format.h>

#include <chrono>
#include <thread>

namespace camopt::apps {

namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds between_looks{100};
/// File systems over a network may show a new file only after a while, and rank 0 may check its rows longer.
constexpr std::chrono::seconds patience_with_rank_zero{60};
/// In which a launcher ends the other ranks, once rank 0 has reported the error that they have too.
constexpr std::chrono::seconds patience_with_launcher{3};

/// map.ranks/1of2, map.ranks/2of2
std::vector<std::string> part_paths(const SweepRequest& request, int ranks) {
    fs::path out = fs::absolute(request.out).lexically_normal();
    if (!out.has_filename()) out = out.parent_path();  // "map/"
    std::vector<std::string> parts;
    for (int i = 1; i <= ranks; ++i) parts.push_back(fmt::format("{}.ranks/{}of{}", out.string(), i, ranks));
    return parts;
}

bool is_complete(const fs::path& folder) {
    return !is_unused_sweep_folder(folder) && SweepFolder::open(folder).missing_chunks().empty();
}

/// One after another; false: interrupted.
bool wait_for_parts(const std::vector<std::string>& parts) {
    return std::ranges::all_of(parts, [](const std::string& part) {
        while (!is_complete(part)) {
            if (InterruptWatch::interrupted()) return false;
            std::this_thread::sleep_for(between_looks);
        }
        return true;
    });
}

/// Also compares the sweeps: the merge would find a difference only at the end.
void wait_for_start_of_rank_zero(const std::string& part, const SweepIdentity& mine) {
    const auto last = std::chrono::steady_clock::now() + patience_with_rank_zero;
    while (is_unused_sweep_folder(part)) {
        if (std::chrono::steady_clock::now() > last)
            throw InputError(
                fmt::format("found no {}, where rank 0 works; allowed: --out on a file system that all "
                            "machines share",
                            part));
        std::this_thread::sleep_for(between_looks);
    }
    if (const std::string other = difference(SweepFolder::open(part).identity(), mine); !other.empty())
        throw InputError(
            fmt::format("found another sweep than in {}: {}; allowed: the same scene, tables and camopt on "
                        "all machines",
                        part, other));
}

void merge_parts(const std::vector<std::string>& parts, const SweepFolder& whole) {
    const SweepParts solved(parts);
    const fs::path results = whole.path() / "rows";
    for (const fs::path part : parts) {  // before the chunks: a folder that has them all is not merged again
        if (!fs::exists(part / "rows")) continue;
        prepare_folder(results);
        const std::vector<fs::directory_entry> rows(fs::directory_iterator(part / "rows"), {});
        for (const fs::directory_entry& row : rows) {
            const fs::path target = results / row.path().filename();
            fs::remove_all(target);
            fs::rename(row.path(), target);
        }
    }
    solved.write_to(whole);
}

/// One rank of a sweep whose rows are checked.
struct Rank {
    const SweepRequest& request;
    const RankLaunch& launch;
    SweepJob& job;
    const SweepIdentity identity = checked_sweep(request, job).identity;
    const std::vector<std::string> parts = part_paths(request, launch.size);
};

/// `whole`: of rank 0, which waits for the other parts too.
ExitCode solve_part(const Rank& rank, WorkFolder* whole) {
    SweepRequest request = rank.request;
    request.out = rank.parts[rank.launch.rank];
    WorkFolder part(request, {rank.identity, {rank.launch.rank + 1, rank.launch.size}});
    const InterruptWatch watch;
    const PoolOutcome outcome =
        solve_missing_chunks(part.folder(), rank.job, request.workers.value_or(1), [&] {
            part.leave_to_parent();
            if (whole) whole->leave_to_parent();
        });
    if (!whole) return outcome == PoolOutcome::finished ? success : interrupted;
    const bool all = outcome == PoolOutcome::finished && wait_for_parts(rank.parts);
    return all ? success : tell_interruption(part.folder());
}

ExitCode be_rank_zero(const Rank& rank) {
    WorkFolder whole(rank.request, {rank.identity, {}});
    if (!whole.folder().missing_chunks().empty()) {
        if (const ExitCode code = solve_part(rank, &whole); code != success) return code;
        merge_parts(rank.parts, whole.folder());
    }
    return finish_sweep(whole.folder(), rank.job.first_scene(), rank.request.units);
}

ExitCode be_other_rank(const Rank& rank) {
    if (rank.request.resume && is_complete(rank.request.out)) return success;
    wait_for_start_of_rank_zero(rank.parts.front(), rank.identity);
    return solve_part(rank, nullptr);
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
        const Rank rank{request, launch, job};
        return launch.rank == 0 ? be_rank_zero(rank) : be_other_rank(rank);
    } catch (const InputError& error) {
        if (launch.rank == 0) throw;
        std::this_thread::sleep_for(patience_with_launcher);
        throw InputError(fmt::format("rank {}: {}", launch.rank, error.what()));
    }
}

}  // namespace camopt::apps
