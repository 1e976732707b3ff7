// SPDX-License-Identifier: MIT
// camopt table: a published table computed again, with proofs.
#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/progress.hpp"
#include "output/reference_table_csv.hpp"
#include "output/reference_table_json.hpp"
#include "output/reference_table_svg.hpp"
#include "output/reference_table_text.hpp"
#include "output/result_folder.hpp"
#include "output/text_file.hpp"
#include "studies/reference_table.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

namespace camopt::apps {

namespace {

struct TableRun {
    ReferenceTable table;
    bool interrupted = false;
};

TableRun computed_table() {
    const InterruptWatch watch;
    const auto progress = terminal_progress();
    const auto finished = [&](const std::string& what) {
        if (progress) progress("solved " + what);
    };
    TableRun run{spline_versus_modified_sine({InterruptWatch::interrupted, {}}, finished), false};
    end_progress();
    run.interrupted = InterruptWatch::interrupted();
    return run;
}

void write_table_folder(const std::filesystem::path& folder, const ReferenceTable& table) {
    write_text_file(folder / "table.json", reference_table_json(table));
    write_text_file(folder / "table.md", reference_table_markdown(table));
    write_text_file(folder / "table.svg", reference_table_svg(table));
    write_text_file(folder / "optimum_points.csv", optimum_points_csv(table));
    write_text_file(folder / "convergence.csv", convergence_csv(table));
    write_text_file(folder / "laws.csv", laws_csv(table));
    write_text_file(folder / "weights.csv", weights_csv(table));
}

/// Success only where every row is proved optimal: a table with a hole in it must not pass for a whole one.
ExitCode exit_code_of(const ReferenceTable& table) {
    const auto optimal = [](const auto& row) { return row.optimum.certificate.verdict == Verdict::optimal; };
    return std::ranges::all_of(table.convergence, optimal) && std::ranges::all_of(table.weights, optimal)
               ? success
               : failure;
}

}  // namespace

ExitCode table_command(const TableRequest& request) {
    if (!request.out.empty()) prepare_folder(request.out);
    const TableRun run = computed_table();
    if (run.interrupted) {
        std::fputs("camopt: interrupted; the table is incomplete and was not written\n", stderr);
        return failure;
    }
    if (!request.out.empty()) write_table_folder(request.out, run.table);
    const std::string text = request.json ? reference_table_json(run.table) : reference_table_text(run.table);
    std::fputs(text.c_str(), stdout);
    return exit_code_of(run.table);
}

}  // namespace camopt::apps
