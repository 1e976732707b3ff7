// SPDX-License-Identifier: MIT
// camopt report: report.md and report.html of a result folder, written again; nothing is solved.
#include "apps/commands.hpp"
#include "apps/scene_loading.hpp"
#include "apps/terminal.hpp"
#include "output/page/page_html.hpp"
#include "output/report/folder_update.hpp"
#include "output/report/report.hpp"
#include "output/report/result_folder_reader.hpp"

#include <fmt/format.h>

namespace camopt::apps {

ExitCode report_command(const ReportRequest& request) {
    const auto load = [](const std::string& text, const std::string& name) {
        return load_scene(SceneText{name, text}, {});
    };
    const ResultFolder result = read_result_folder(request.folder, load);
    FolderUpdate folder(request.folder);
    folder.write("report.html", report_html(result.solution, result.origin));
    folder.write("report.md", report_markdown(result.solution, result.origin));
    std::string text;
    for (const auto& path : folder.finish()) text += fmt::format("  wrote {}\n", path.string());
    print(text);
    return success;
}

}  // namespace camopt::apps
