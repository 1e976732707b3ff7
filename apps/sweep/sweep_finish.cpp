// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_finish.hpp"

#include "apps/sweep/sweep_pictures.hpp"
#include "apps/terminal.hpp"
#include "output/words/sweep_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt::apps {

ExitCode finish_sweep(const SweepFolder& folder, const Scene* scene) {
    const SweepShard& shard = folder.shard();
    // The Pareto front of a part would be wrong, so a part gets no sweep.csv.
    const SweepTable table = shard.is_whole() ? folder.write_table() : folder.table();
    std::string text = shard.is_whole() ? fmt::format("Sweep of {}\n", folder.identity().scene_file)
                                        : fmt::format("Sweep of {}, shard {} of {}\n",
                                                      folder.identity().scene_file, shard.index, shard.count);
    text += sweep_text(table, scene);
    if (shard.is_whole()) write_sweep_pictures(folder, table);
    text += shard.is_whole() ? fmt::format("  wrote {}\n", folder.table_path().string())
                             : fmt::format("  kept in {}; join the shards with camopt sweep merge\n",
                                           folder.path().string());
    print(text);
    return std::ranges::find(table.rows, Verdict::failed, &SweepRow::verdict) == table.rows.end() ? success
                                                                                                  : failure;
}

}  // namespace camopt::apps
