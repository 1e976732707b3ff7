// SPDX-License-Identifier: MIT
// camopt reproduce: a paper's tables and figures beside ours.
#include "apps/commands.hpp"
#include "apps/interruptible_run.hpp"
#include "apps/terminal.hpp"
#include "output/chart/studies/paper_figure_svg.hpp"
#include "output/csv/paper_report_csv.hpp"
#include "output/json/paper_report_json.hpp"
#include "output/report/folder_update.hpp"
#include "output/report/result_folder.hpp"
#include "output/words/paper_report_text.hpp"
#include "studies/papers/paper_catalogue.hpp"

#include <filesystem>
#include <string>

namespace camopt::apps {

namespace {

void write_report_folder(const std::filesystem::path& path, const PaperReport& report) {
    FolderUpdate folder(path);
    folder.write("report.json", paper_report_json(report));
    folder.write("report.md", paper_report_markdown(report));
    for (const PaperTable& table : report.tables) folder.write(table.key + ".csv", paper_table_csv(table));
    for (const PaperFigure& figure : report.figures) {
        folder.write(figure.key + ".csv", paper_figure_csv(figure));
        folder.write(figure.key + ".svg", paper_figure_svg(figure));
    }
    folder.finish();
}

}  // namespace

ExitCode reproduce_command(const ReproduceRequest& request) {
    const PaperInfo& paper = find_paper(request.paper);
    if (!request.out.empty()) prepare_folder(request.out);
    const auto report = interruptible_run("the report", "", paper.report);
    if (!report) return failure;
    if (!request.out.empty()) write_report_folder(request.out, *report);
    const std::string text = request.json ? paper_report_json(*report) : paper_report_text(*report);
    print(text);
    return report->faults.empty() ? success : failure;
}

}  // namespace camopt::apps
