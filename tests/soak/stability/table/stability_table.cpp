// SPDX-License-Identifier: MIT
// stability_table FOLDER [quick | GROUP] [--results]: runs every row of the stability table (all; the quick
// ones; one group) and writes stability.csv, stability.md and stability.svg into the folder. Ends with code 1
// where a row is wrong. With --results the result folder of each row that solved a scene is written too, as
// FOLDER/results/NUMBER: tests/certificates/stability_rows.py has them judged.
#include "benchmarks/parts/machine.hpp"
#include "core/text/text_file.hpp"
#include "report/folders/result_folder.hpp"
#include "tests/soak/stability/stability_cases.hpp"
#include "tests/soak/stability/table/stability_report.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

namespace camopt::stability {

namespace {

bool is_chosen(const StabilityCase& one, const std::string& choice) {
    if (choice.empty()) return true;
    return choice == "quick" ? one.quick : one.group == choice;
}

/// What the program was asked for.
struct Request {
    std::filesystem::path folder;
    std::string choice;
    bool results = false;
};

/// The result folder of what the row solved, with its scene, and its name.
void write_results(const std::filesystem::path& folder, const StabilityRow& row) {
    RunOrigin origin;
    origin.scene_text = row.scene;
    write_result_folder(folder, *row.solution, origin);
    write_text_file(folder / "row.txt", row.group + ": " + row.name + " " + row.backend + "\n");
}

std::vector<StabilityRow> rows_of(const Request& request) {
    std::vector<StabilityRow> rows;
    for (const StabilityCase& one : all_cases()) {
        if (!is_chosen(one, request.choice)) continue;
        rows.push_back(one.run());
        StabilityRow& row = rows.back();
        if (request.results && row.solution)
            write_results(request.folder / "results" / std::to_string(rows.size()), row);
        row.solution.reset();
        std::fprintf(stderr, "%-6s %s: %s %s, %.3g s%s%s\n", name_of(row.judgement), row.group.c_str(),
                     row.name.c_str(), row.backend.c_str(), row.seconds, row.why.empty() ? "" : ": ",
                     row.why.c_str());
    }
    return rows;
}

int run(const Request& request) {
    const std::filesystem::path& folder = request.folder;
    prepare_folder(folder);
    const std::vector<StabilityRow> rows = rows_of(request);
    write_text_file(folder / "stability.csv", stability_csv(rows));
    write_text_file(folder / "stability.md", stability_markdown(rows, benchmarks::machine_line()));
    write_text_file(folder / "stability.svg", stability_svg(rows, benchmarks::machine_line()));
    int wrong = 0;
    for (const StabilityRow& row : rows) wrong += row.judgement == Judgement::wrong ? 1 : 0;
    std::fprintf(stderr, "%zu rows, %d wrong\n", rows.size(), wrong);
    return wrong == 0 ? 0 : 1;
}

}  // namespace

}  // namespace camopt::stability

int main(int count, char** words) {
    camopt::stability::Request request;
    int given = count - 1;
    if (given > 1 && std::string(words[given]) == "--results") {
        request.results = true;
        --given;
    }
    if (given != 1 && given != 2) {
        std::fputs("usage: stability_table FOLDER [quick | GROUP] [--results]\n", stderr);
        return 2;
    }
    request.folder = words[1];
    if (given == 2) request.choice = words[2];
    try {
        return camopt::stability::run(request);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "stability_table: %s\n", error.what());
        return 1;
    }
}
