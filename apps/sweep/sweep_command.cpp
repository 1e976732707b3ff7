// SPDX-License-Identifier: MIT
// camopt sweep: many solves of one scene, by worker processes, into a folder that can be continued.
#include "apps/commands.hpp"
#include "apps/folder_lock.hpp"
#include "apps/interrupt.hpp"
#include "apps/scene_loading.hpp"
#include "apps/sweep/sweep_finish.hpp"
#include "apps/sweep/sweep_request.hpp"
#include "apps/sweep/sweep_solve.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "core/version.hpp"
#include "studies/sweep/sweep_check.hpp"

#include <fmt/format.h>

#include <thread>

namespace camopt::apps {

namespace {

/// The folder to work in: a new one, or with --resume the one that holds this very sweep.
SweepFolder folder_for(const SweepRequest& request, const StoredSweep& sweep) {
    if (!request.resume || is_unused_sweep_folder(request.out))
        return SweepFolder::create(request.out, sweep);
    SweepFolder folder = SweepFolder::open(request.out);
    const std::string other = difference(folder.identity(), sweep.identity);
    if (!other.empty())
        throw InputError(fmt::format("{} holds another sweep: {}; allowed: the same sweep, or another folder",
                                     request.out, other));
    const SweepShard &found = folder.shard(), &asked = sweep.shard;
    if (found.index != asked.index || found.count != asked.count)
        throw InputError(
            fmt::format("{} holds shard {}/{}, not {}/{}; allowed: the same shard, or another "
                        "folder",
                        request.out, found.index, found.count, asked.index, asked.count));
    return folder;
}

int worker_count(const SweepRequest& request) {
    if (request.workers) return *request.workers;
    const unsigned cores = std::thread::hardware_concurrency();
    return cores > 0 ? static_cast<int>(cores) : 1;
}

ExitCode tell_interruption(const SweepFolder& folder) {
    const std::size_t finished = folder.finished_chunks().size();
    print_error(
        fmt::format("camopt: interrupted; {} of {} chunks are finished and kept in {}; the same command "
                    "with --resume goes on\n",
                    finished, folder.chunks().size(), folder.path().string()));
    return interrupted;
}

}  // namespace

ExitCode sweep_command(const SweepRequest& request) {
    if (request.out.empty())
        throw InputError("--out is missing: camopt sweep SCENE --out DIR; see camopt sweep --help");
    const SceneText scene = read_scene_text(request.scene);
    const std::vector<std::string> settings = sweep_settings(request);
    const SweepPlan plan = sweep_plan(request);
    SweepScenes scenes(plan, [&](std::span<const std::string> row) {
        std::vector<std::string> all = settings;
        all.insert(all.end(), row.begin(), row.end());
        return load_scene(scene, all);
    });
    const SweepColumns columns = check_rows(scenes);
    const SweepFolder folder =
        folder_for(request, {{std::string(version()),
                              request.scene,
                              scene.text,
                              settings,
                              sweep_axes(request),
                              fingerprint(plan),
                              columns,
                              {plan.rows(), request.chunk.value_or(chunk_size_for(plan.rows()))}},
                             sweep_shard(request)});
    FolderLock lock(folder.path());
    if (const int damaged = folder.remove_leftovers(); damaged > 0)
        print_error(fmt::format("camopt: {} chunk(s) in {} were damaged and are solved again\n", damaged,
                                request.out));
    const InterruptWatch watch;
    const PoolOutcome outcome =
        solve_missing_chunks(folder, scenes, worker_count(request), [&] { lock.leave_to_parent(); });
    if (outcome == PoolOutcome::stopped) return tell_interruption(folder);
    return finish_sweep(folder, &scenes.scene(0));
}

}  // namespace camopt::apps
