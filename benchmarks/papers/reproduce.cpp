// SPDX-License-Identifier: MIT
// reproduce PAPER [--json] [--out DIR]: a paper's tables and figures computed again, next to the printed
// ones. Exit codes: 0 everything was computed and proved, 1 something was not, 2 wrong input
// (benchmarks/README.md).
#include "benchmarks/papers/paper_json.hpp"
#include "benchmarks/papers/papers.hpp"
#include "core/errors.hpp"
#include "report/folders/result_folder.hpp"
#include "report/papers/paper_output.hpp"

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

#include <cstdio>

namespace camopt {

namespace {

struct Request {
    std::string paper;
    std::string out;  ///< folder; empty: nothing is written
    bool json = false;
};

int report_on(const Request& request) {
    const PaperInfo& paper = find_paper(request.paper);
    if (!request.out.empty()) prepare_folder(request.out);
    const PaperReport report = paper.report({}, {});
    const Document document = paper_document(report);
    const std::string json = paper_report_json(report);
    if (!request.out.empty()) {
        FolderUpdate folder(request.out);
        folder.write("report.json", json);
        for (const FolderFile& file : text_files(document, {})) folder.write(file.name, file.text);
        folder.finish();
    }
    const std::string text = request.json ? json : console_text(document);
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw std::system_error(errno, std::generic_category(), "cannot write to standard output");
    return report.faults.empty() ? 0 : 1;
}

int parse_and_run(int count, const char* const* words) {
    std::vector<std::string_view> ids;
    for (const PaperInfo& paper : paper_catalogue()) ids.push_back(paper.id);
    CLI::App program("Compute a paper's tables and figures again and compare them with the printed ones",
                     "reproduce");
    Request request;
    program.add_option("PAPER", request.paper, fmt::format("{}", fmt::join(ids, ", ")))
        ->type_name("")
        ->required();
    program.add_option("--out", request.out, "Write JSON, CSV, Markdown and the pictures here")
        ->type_name("DIR");
    program.add_flag("--json", request.json, "Print the report as JSON and nothing else");
    try {
        program.parse(count, words);
    } catch (const CLI::Success& asked_for_help) {
        return program.exit(asked_for_help);
    } catch (const CLI::ParseError& error) {
        throw InputError(fmt::format("{} (see reproduce --help)", error.what()));
    }
    return report_on(request);
}

}  // namespace

}  // namespace camopt

int main(int count, char** words) {
    try {
        return camopt::parse_and_run(count, words);
    } catch (const camopt::InputError& error) {
        fmt::print(stderr, "reproduce: {}\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "reproduce: {}\n", error.what());
        return 1;
    }
}
