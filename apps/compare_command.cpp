// SPDX-License-Identifier: MIT
// camopt compare: every classical law on the scene, beside its optimum.
#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/progress.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "output/chart/comparison_svg.hpp"
#include "output/csv/comparison_csv.hpp"
#include "output/json/comparison_json.hpp"
#include "output/page/study_html.hpp"
#include "output/report/folder_update.hpp"
#include "output/report/result_folder.hpp"
#include "output/words/comparison_text.hpp"
#include "studies/compare/comparison.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace camopt::apps {

namespace {

Comparison compare_with_progress(const Scene& scene) {
    const InterruptWatch watch;
    const SolveControl control{InterruptWatch::interrupted, terminal_progress()};
    Comparison comparison = compare(scene, control);
    end_progress();
    return comparison;
}

}  // namespace

ExitCode compare_command(const CompareRequest& request) {
    LoadedScene loaded = load_scene_and_text(request.scene, with_solver(request.settings, request.solver));
    if (!request.out.empty()) prepare_folder(request.out);
    Comparison comparison = compare_with_progress(loaded.scene);
    show_in(comparison.optimum.scene, request.units);
    const RunOrigin origin{request.scene, request.command, std::move(loaded.text)};
    if (!request.out.empty()) {
        FolderUpdate folder(request.out);
        folder.write("comparison.csv", comparison_csv(comparison));
        folder.write("comparison.svg", comparison_svg(comparison));
        folder.write("comparison.html", comparison_html(comparison, origin));
        folder.write("comparison.json", comparison_json(comparison, origin));
        folder.finish();
    }
    const std::string text = request.json ? comparison_json(comparison, origin) : comparison_text(comparison);
    print(text);
    return exit_code_of(comparison.optimum.certificate.verdict);
}

}  // namespace camopt::apps
