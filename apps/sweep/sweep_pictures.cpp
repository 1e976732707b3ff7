// SPDX-License-Identifier: MIT
#include "apps/sweep/sweep_pictures.hpp"

#include "apps/interrupt.hpp"
#include "apps/progress.hpp"
#include "apps/scene_loading.hpp"
#include "output/chart/sweep/sweep_svg.hpp"
#include "output/page/study_html.hpp"
#include "output/report/folder_update.hpp"

#include <optional>
#include <vector>

namespace camopt::apps {

namespace {

std::vector<PeakTriple> peaks_of_rows(const SweepTable& table) {
    std::vector<PeakTriple> peaks;
    for (const SweepRow& row : table.rows) {
        const auto &velocity = row.figure(SweepFigure::velocity),
                   &acceleration = row.figure(SweepFigure::acceleration),
                   &jerk = row.figure(SweepFigure::jerk);
        if (row.is_feasible() && velocity && acceleration && jerk)
            peaks.push_back({*velocity, *acceleration, *jerk});
    }
    return peaks;
}

}  // namespace

void write_sweep_pictures(const SweepFolder& folder, const SweepTable& table, std::string_view units) {
    const SweepIdentity& identity = folder.identity();
    Scene scene = load_scene({identity.scene_file, identity.scene_text}, identity.settings);
    show_in(scene, units);
    std::optional<LawLosses> losses;
    if (is_weight_sweep(table)) {
        const InterruptWatch watch;
        losses = law_losses(scene, {InterruptWatch::interrupted, terminal_progress()}, peaks_of_rows(table));
        end_progress();
    }
    const SweepPicture picture{table, scene, losses ? &*losses : nullptr};
    FolderUpdate update(folder.path());
    update.write("sweep.svg", sweep_svg(picture));
    update.write("sweep.html", sweep_html(picture, identity));
    update.finish();
}

}  // namespace camopt::apps
