// SPDX-License-Identifier: MIT
// What a sweep is made from, and the folder it works in: what every way to run one begins with.
#pragma once

#include "apps/commands.hpp"
#include "apps/scene_loading.hpp"
#include "apps/sweep/rank_launch.hpp"
#include "core/platform/files.hpp"
#include "core/platform/workers.hpp"
#include "report/document/document_text.hpp"
#include "report/folders/sweep_folder.hpp"
#include "report/json/sweep_json.hpp"
#include "scene/machine_spec.hpp"
#include "studies/compare/law_losses.hpp"
#include "studies/sweep/sweep_run.hpp"

#include <filesystem>
#include <map>

namespace camopt::apps {

/// Scene or machine, settings and rows of the words of a command line. The constructor throws InputError.
class SweepJob {
 public:
    explicit SweepJob(const SweepRequest& request);
    SweepJob(const SweepJob&) = delete;
    SweepJob& operator=(const SweepJob&) = delete;

    [[nodiscard]] const SweepPlan& plan() const { return plan_; }
    /// Reads and checks every row; throws InputError naming the first wrong one.
    [[nodiscard]] SweepColumns check();
    [[nodiscard]] int chunk_size();
    /// Where its chunks are solved. A machine may take a solver that is not safe in threads, and takes
    /// seconds.
    [[nodiscard]] Fence fence() {
        return is_machine_ || !is_safe_in_threads(scenes_.scene(0)) ? Fence::around_each : Fence::around_all;
    }
    /// Rows solved one after another, with their result folders where these are asked for. Workers may be
    /// threads that call this at once.
    [[nodiscard]] std::vector<SweepRow> solve(RowRange rows, const SweepFolder& folder,
                                              const std::function<void(const SweepRow&)>& row_done) const;
    /// Of the first row; null: a machine.
    [[nodiscard]] const Scene* first_scene() { return is_machine_ ? nullptr : &scenes_.scene(0); }
    /// What a folder of this sweep says of itself, with these columns and chunks.
    [[nodiscard]] SweepIdentity identity(const SweepColumns& columns, const Chunking& chunking) const;

 private:
    [[nodiscard]] std::vector<std::string> row_settings(int row) const;  ///< of all rows, then its own
    [[nodiscard]] MachineSpec machine(int row) const;
    [[nodiscard]] SweepRow solve_machine_row(int row, const SweepFolder& folder) const;

    SweepRequest request_;
    SceneText scene_;
    std::vector<std::string> settings_;
    SweepPlan plan_;
    bool is_machine_;
    SweepScenes scenes_;  ///< unless it is a machine
};

/// What the folder of --out is to hold; every row is checked. Throws InputError.
[[nodiscard]] StoredSweep checked_sweep(const SweepRequest& request, SweepJob& job);

/// The folder of --out, held against other programs: a new one, or with --resume the one that holds this very
/// sweep; what a killed run left is gone. The constructor throws InputError.
class WorkFolder {
 public:
    /// share: of this program, if others work in the folder too.
    WorkFolder(const SweepRequest& request, const StoredSweep& sweep, const SweepShard& share = {});

    [[nodiscard]] const SweepFolder& folder() const { return folder_; }
    /// In a forked child.
    void leave_to_parent() { lock_.leave_to_parent(); }

 private:
    SweepFolder folder_;
    FolderLock lock_;
};

/// Keeps a result folder for every row. settings: of all rows, before those of each.
[[nodiscard]] FoundSolution result_keeper(const SweepFolder& folder, const SceneText& scene,
                                          std::vector<std::string> settings);

/// Peaks of the rows that have them.
[[nodiscard]] std::vector<PeakTriple> peaks_of_rows(const SweepTable& table);

/// The files of a study but for its table: picture and page, named after it, report.md, tables.csv; its
/// description, unless `json` is empty.
void write_study(const SweepFolder& folder, const Document& document, const std::string& json = "",
                 const std::vector<FolderFile>& also = {});

/// "interrupted; 12 of 58 chunks are finished and kept in …"
[[nodiscard]] ExitCode tell_interruption(const SweepFolder& folder);

/// Solves the chunks that are missing in the folder; each is written there by its worker as soon as it is
/// finished. The rows of a chunk that crashed twice are failed, with the cause of death as the reason.
/// Progress goes to the terminal, if there is one. begin_child: as of PoolTask.
[[nodiscard]] PoolOutcome solve_missing_chunks(const SweepFolder& folder, SweepJob& job, int workers,
                                               const std::function<void()>& begin_child);

// From the words of camopt sweep to what is asked for. All throw InputError.

/// --vary in their order, then --weights: the last moves fastest, and weights are the cheapest to move.
[[nodiscard]] SweepPlan sweep_plan(const SweepRequest& request);

/// The same as words, for people: "--vary spline.segments=8,16", "--weights simplex:20".
[[nodiscard]] std::vector<std::string> sweep_axes(const SweepRequest& request);

/// --set and --solver, the same for every row.
[[nodiscard]] std::vector<std::string> sweep_settings(const SweepRequest& request);

/// "2/3": the second of three. Empty: the whole.
[[nodiscard]] SweepShard sweep_shard(const SweepRequest& request);

// The end of a sweep whose chunks all stand in its folder.

/// Writes sweep.csv (of a whole sweep, not of a shard), prints the summary. failure where a row failed: an
/// infeasible row is a result, a failed one is none. `scene`: of the first row; `units`: "mm", "in" or empty,
/// of lengths in words and pictures.
[[nodiscard]] ExitCode finish_sweep(const SweepFolder& folder, const Scene* scene = nullptr,
                                    std::string_view units = {});

// The shards of one sweep joined.

class SweepParts {
 public:
    /// Reads every chunk. Throws InputError where they are not all parts of one sweep, each row once.
    explicit SweepParts(const std::vector<std::string>& paths);
    SweepParts(const SweepParts&) = delete;
    SweepParts& operator=(const SweepParts&) = delete;

    [[nodiscard]] const SweepIdentity& identity() const { return parts_.front().identity(); }
    void write_to(const SweepFolder& whole) const;

 private:
    std::vector<SweepFolder> parts_;
    std::map<int, const SweepFolder*> owners_;  ///< which part holds each chunk
};

// camopt sweep under mpirun: one sweep by all ranks.

/// Every rank solves one shard of the chunks into the folder of rank 0, with --workers workers (default 1).
/// Rank 0 then waits for the others, writes the table and prints the summary. Throws InputError; from other
/// ranks than 0 some seconds later, since the launcher ends all ranks when the first one fails.
[[nodiscard]] ExitCode sweep_across_ranks(const SweepRequest& request, const RankLaunch& launch);

}  // namespace camopt::apps
