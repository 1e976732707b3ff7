// SPDX-License-Identifier: MIT
// camopt table: a published table computed again, every optimum proved.
#include "apps/commands.hpp"
#include "apps/terminal.hpp"
#include "report/folders/result_folder.hpp"
#include "report/papers/paper_output.hpp"

namespace camopt::apps {

ExitCode table_command(const TableRequest& request) {
    if (!request.out.empty()) prepare_folder(request.out);
    const auto table = interruptible_run("the table", "solved ", spline_versus_modified_sine);
    if (!table) return failure;
    const PaperReport report = paper_004_report(*table);
    const Document document = paper_document(report);
    const std::string json = reference_table_json(*table);
    if (!request.out.empty()) {
        const InterruptWatch watch;
        FolderUpdate folder(request.out);
        folder.write("table.json", json);
        for (const FolderFile& file : text_files(document, {})) folder.write(file.name, file.text);
        folder.finish();
    }
    print(request.json ? json : console_text(document));
    // Success only where every row is proved: an incomplete table must not pass as a whole one.
    return report.faults.empty() ? success : failure;
}

}  // namespace camopt::apps
