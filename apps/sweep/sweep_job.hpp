// SPDX-License-Identifier: MIT
// What a sweep is made from, and the folder it works in: what every way to run one begins with.
#pragma once

#include "apps/commands.hpp"
#include "apps/folder_lock.hpp"
#include "apps/scene_loading.hpp"
#include "output/report/sweep_folder.hpp"
#include "studies/sweep/sweep_plan.hpp"

#include <string>
#include <vector>

namespace camopt::apps {

/// Scene, settings and rows of the words of a command line. The constructor throws InputError.
class SweepJob {
 public:
    explicit SweepJob(const SweepRequest& request);
    SweepJob(const SweepJob&) = delete;
    SweepJob& operator=(const SweepJob&) = delete;

    [[nodiscard]] SweepScenes& scenes() { return scenes_; }
    /// What a folder of this sweep says of itself, with these columns and chunks.
    [[nodiscard]] SweepIdentity identity(const SweepColumns& columns, const Chunking& chunking) const;

 private:
    SweepRequest request_;
    SceneText scene_;
    std::vector<std::string> settings_;
    SweepPlan plan_;
    SweepScenes scenes_;
};

/// The folder of --out, held against other programs: a new one, or with --resume the one that holds this very
/// sweep; what a killed run left is gone. Every row is checked before. The constructor throws InputError.
class WorkFolder {
 public:
    WorkFolder(const SweepRequest& request, SweepJob& job);

    [[nodiscard]] const SweepFolder& folder() const { return folder_; }
    /// In a forked child.
    void leave_to_parent() { lock_.leave_to_parent(); }

 private:
    SweepFolder folder_;
    FolderLock lock_;
};

/// "interrupted; 12 of 58 chunks are finished and kept in …"
[[nodiscard]] ExitCode tell_interruption(const SweepFolder& folder);

}  // namespace camopt::apps
