// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_job.hpp"

#include "apps/sweep/sweep_request.hpp"
#include "apps/terminal.hpp"
#include "core/errors.hpp"
#include "core/version.hpp"
#include "studies/sweep/sweep_check.hpp"

#include <fmt/format.h>

namespace camopt::apps {

namespace {

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

StoredSweep checked_sweep(const SweepRequest& request, SweepJob& job) {
    const int rows = job.scenes().plan().rows();
    const Chunking chunking{rows, request.chunk.value_or(chunk_size_for(rows))};
    return {job.identity(check_rows(job.scenes()), chunking), sweep_shard(request)};
}

}  // namespace

SweepJob::SweepJob(const SweepRequest& request)
    : request_(request),
      scene_(read_scene_text(request.scene)),
      settings_(sweep_settings(request)),
      plan_(sweep_plan(request)),
      scenes_(plan_, [this](std::span<const std::string> row) {
          std::vector<std::string> all = settings_;
          all.insert(all.end(), row.begin(), row.end());
          return load_scene(scene_, all);
      }) {}

SweepIdentity SweepJob::identity(const SweepColumns& columns, const Chunking& chunking) const {
    return {std::string(version()), request_.scene,     scene_.text, settings_,
            sweep_axes(request_),   fingerprint(plan_), columns,     chunking};
}

WorkFolder::WorkFolder(const SweepRequest& request, SweepJob& job)
    : folder_(folder_for(request, checked_sweep(request, job))), lock_(folder_.path()) {
    if (const int damaged = folder_.remove_leftovers(); damaged > 0)
        print_error(fmt::format("camopt: {} chunk(s) in {} were damaged and are solved again\n", damaged,
                                request.out));
}

ExitCode tell_interruption(const SweepFolder& folder) {
    const std::size_t finished = folder.finished_chunks().size();
    print_error(
        fmt::format("camopt: interrupted; {} of {} chunks are finished and kept in {}; the same command "
                    "with --resume goes on\n",
                    finished, folder.chunks().size(), folder.path().string()));
    return interrupted;
}

}  // namespace camopt::apps
