// SPDX-License-Identifier: MIT
// camopt table: a published table computed again, with proofs.
#include "apps/commands.hpp"
#include "apps/interruptible_run.hpp"
#include "apps/terminal.hpp"
#include "output/chart/reference_table/reference_table_svg.hpp"
#include "output/csv/reference_table_csv.hpp"
#include "output/json/reference_table_json.hpp"
#include "output/report/folder_update.hpp"
#include "output/report/result_folder.hpp"
#include "output/words/tables/reference_table_text.hpp"
#include "studies/compare/reference_table.hpp"

#include <algorithm>
#include <filesystem>
#include <string>

namespace camopt::apps {

namespace {

void write_table_folder(const std::filesystem::path& path, const ReferenceTable& table) {
    FolderUpdate folder(path);
    folder.write("table.json", reference_table_json(table));
    folder.write("table.md", reference_table_markdown(table));
    folder.write("table.svg", reference_table_svg(table));
    folder.write("optimum_points.csv", optimum_points_csv(table));
    folder.write("convergence.csv", convergence_csv(table));
    folder.write("laws.csv", laws_csv(table));
    folder.write("weights.csv", weights_csv(table));
    folder.finish();
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
    const auto table = interruptible_run("the table", "solved ", spline_versus_modified_sine);
    if (!table) return failure;
    if (!request.out.empty()) write_table_folder(request.out, *table);
    const std::string text = request.json ? reference_table_json(*table) : reference_table_text(*table);
    print(text);
    return exit_code_of(*table);
}

}  // namespace camopt::apps
