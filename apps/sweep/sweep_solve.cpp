// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_solve.hpp"

#include "apps/interrupt.hpp"
#include "apps/progress.hpp"
#include "apps/sweep/sweep_progress.hpp"

namespace camopt::apps {

namespace {

void write_lost_chunk(const SweepFolder& folder, const SweepPlan& plan, int chunk,
                      const std::string& reason) {
    const RowRange range = folder.identity().chunking.range(chunk);
    std::vector<SweepRow> rows;
    for (int row = range.begin; row < range.end; ++row)
        rows.push_back(failed_row(row, plan.row(row), reason));
    folder.write_chunk(chunk, rows);
}

}  // namespace

PoolTask chunk_task(const SweepFolder& folder, SweepScenes& scenes) {
    PoolTask task;
    task.work = [&](int chunk, const std::function<void(int)>& tell) {
        folder.write_chunk(chunk, solve_chunk(scenes, folder.identity().chunking.range(chunk), {},
                                              [&](const SweepRow& row) { tell(row.number); }));
    };
    task.lost = [&](int chunk, const std::string& reason) {
        write_lost_chunk(folder, scenes.plan(), chunk, reason);
    };
    return task;
}

PoolOutcome solve_missing_chunks(const SweepFolder& folder, SweepScenes& scenes, int workers,
                                 const std::function<void()>& begin_worker) {
    SweepProgress progress(folder.identity().chunking, folder.chunks(), folder.missing_chunks());
    const auto line = terminal_progress();
    PoolTask task = chunk_task(folder, scenes);
    task.units = folder.missing_chunks();
    task.workers = workers;
    task.begin_worker = begin_worker;
    task.told = [&](int row) { progress.add(row); };
    if (line) task.tick = [&] { line(progress.text()); };
    task.stop_requested = InterruptWatch::interrupted;
    const PoolOutcome outcome = run_workers(task);
    end_progress();
    return outcome;
}

}  // namespace camopt::apps
