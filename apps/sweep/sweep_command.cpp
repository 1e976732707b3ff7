// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_job.hpp"
#include "core/platform/console.hpp"

#include <fmt/format.h>

#include <thread>

namespace camopt::apps {

namespace {

int worker_count(const SweepRequest& request) {
    if (request.workers) return *request.workers;
    const unsigned cores = std::thread::hardware_concurrency();
    return cores > 0 ? static_cast<int>(cores) : 1;
}

// camopt sweep merge: the shards of one sweep joined.
std::string rows_text(const SweepFolder& folder, int chunk) {
    const RowRange range = folder.identity().chunking.range(chunk);
    return fmt::format("rows {} to {}", range.begin, range.end - 1);
}

std::vector<SweepFolder> open_parts(const std::vector<std::string>& paths) {
    std::vector<SweepFolder> parts;
    for (const std::string& path : paths) {
        parts.push_back(SweepFolder::open(path));
        const std::string other = difference(parts.back().identity(), parts.front().identity());
        if (!other.empty())
            throw InputError(
                fmt::format("{} is not part of the sweep in {}: {}; allowed: shards of one sweep", path,
                            paths.front(), other));
    }
    return parts;
}

/// Which part holds each chunk.
std::map<int, const SweepFolder*> owners(const std::vector<SweepFolder>& parts) {
    std::map<int, const SweepFolder*> owner;
    for (const SweepFolder& part : parts)
        for (const int chunk : part.finished_chunks())
            if (const auto [place, is_new] = owner.emplace(chunk, &part); !is_new)
                throw InputError(fmt::format("{} are in {} and in {}; allowed: each row once",
                                             rows_text(part, chunk), place->second->path().string(),
                                             part.path().string()));
    const SweepFolder& first = parts.front();
    for (int chunk = 0; chunk < first.identity().chunking.count(); ++chunk) {
        if (owner.contains(chunk)) continue;
        for (const SweepFolder& part : parts)
            if (part.shard().holds(chunk))
                throw InputError(fmt::format("{} are missing: {} is not finished; continue it with --resume",
                                             rows_text(first, chunk), part.path().string()));
        throw InputError(fmt::format("{} are missing: no given folder holds their shard; allowed: all shards",
                                     rows_text(first, chunk)));
    }
    return owner;
}

}  // namespace

// camopt sweep: many solves of one scene into a folder that can be continued.

SweepParts::SweepParts(const std::vector<std::string>& paths)
    : parts_(open_parts(paths)), owners_(owners(parts_)) {
    for (const auto& [chunk, part] : owners_) (void)part->read_chunk(chunk);
}

void SweepParts::write_to(const SweepFolder& whole) const {
    for (const auto& [chunk, part] : owners_) whole.write_chunk_text(chunk, part->chunk_text(chunk));
}

ExitCode sweep_command(const SweepRequest& request) {
    if (request.out.empty())
        throw InputError("--out is missing: camopt sweep SCENE --out DIR; see camopt sweep --help");
    if (const RankLaunch launch = rank_launch(); launch.size > 1) return sweep_across_ranks(request, launch);
    SweepJob job(request);
    WorkFolder work(request, checked_sweep(request, job));
    const InterruptWatch watch;
    const PoolOutcome outcome =
        solve_missing_chunks(work.folder(), job, worker_count(request), [&] { work.leave_to_parent(); });
    if (outcome == PoolOutcome::stopped) return tell_interruption(work.folder());
    return finish_sweep(work.folder(), job.first_scene(), request.units);
}

ExitCode sweep_merge_command(const SweepMergeRequest& request) {
    if (request.out.empty()) throw InputError("--out is missing: camopt sweep merge DIR1 DIR2 … --out DIR");
    const SweepParts parts(request.parts);  // before anything is written
    const SweepFolder whole = SweepFolder::create(request.out, {parts.identity(), {}});
    parts.write_to(whole);
    return finish_sweep(whole);
}

}  // namespace camopt::apps
