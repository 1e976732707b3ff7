// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_finish.hpp"

#include "apps/scene_loading.hpp"
#include "apps/sweep/sweep_pictures.hpp"
#include "apps/terminal.hpp"
#include "output/words/sweep_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt::apps {

namespace {

/// Their page holds every row: 80 MB of it, more than a browser likes.
constexpr std::size_t most_drawn_rows = 100'000;

}  // namespace

ExitCode finish_sweep(const SweepFolder& folder, const Scene* scene, std::string_view units) {
    const SweepShard& shard = folder.shard();
    // The Pareto front of a part would be wrong, so a part gets no sweep.csv.
    SweepTable table = shard.is_whole() ? folder.write_table() : folder.table();
    // The table is written, its columns are in mm: from here on for people.
    table.columns.length_unit = length_unit_of(units, table.columns.length_unit);
    std::string text = shard.is_whole() ? fmt::format("Sweep of {}\n", folder.identity().scene_file)
                                        : fmt::format("Sweep of {}, shard {} of {}\n",
                                                      folder.identity().scene_file, shard.index, shard.count);
    if (scene != nullptr) {
        Scene shown = *scene;
        show_in(shown, units);
        text += sweep_text(table, &shown);
    } else {
        text += sweep_text(table);
    }
    if (shard.is_whole() && table.rows.size() <= most_drawn_rows)
        write_sweep_pictures(folder, table, units);
    else if (shard.is_whole())
        text += fmt::format("  no sweep.svg and sweep.html: they are drawn of at most {} rows\n",
                            most_drawn_rows);
    text += shard.is_whole() ? fmt::format("  wrote {}\n", folder.table_path().string())
                             : fmt::format("  kept in {}; join the shards with camopt sweep merge\n",
                                           folder.path().string());
    print(text);
    return std::ranges::find(table.rows, Verdict::failed, &SweepRow::verdict) == table.rows.end() ? success
                                                                                                  : failure;
}

}  // namespace camopt::apps
