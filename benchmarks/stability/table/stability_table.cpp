// SPDX-License-Identifier: MIT
// stability_table FOLDER [quick | GROUP]: runs every row of the stability table (all; the quick ones; one
// group) and writes stability.csv, stability.md and stability.svg into the folder. Ends with code 1 where a
// row is wrong.
#include "benchmarks/parts/machine.hpp"
#include "benchmarks/stability/stability_cases.hpp"
#include "benchmarks/stability/table/stability_report.hpp"
#include "output/report/result_folder.hpp"
#include "output/report/text_file.hpp"

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

std::vector<StabilityRow> rows_of(const std::string& choice) {
    std::vector<StabilityRow> rows;
    for (const StabilityCase& one : all_cases()) {
        if (!is_chosen(one, choice)) continue;
        rows.push_back(one.run());
        const StabilityRow& row = rows.back();
        std::fprintf(stderr, "%-6s %s: %s %s, %.3g s%s%s\n", name_of(row.judgement), row.group.c_str(),
                     row.name.c_str(), row.backend.c_str(), row.seconds, row.why.empty() ? "" : ": ",
                     row.why.c_str());
    }
    return rows;
}

int run(const std::filesystem::path& folder, const std::string& choice) {
    prepare_folder(folder);
    const std::vector<StabilityRow> rows = rows_of(choice);
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
    if (count != 2 && count != 3) {
        std::fputs("usage: stability_table FOLDER [quick | GROUP]\n", stderr);
        return 2;
    }
    try {
        return camopt::stability::run(words[1], count == 3 ? words[2] : "");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "stability_table: %s\n", error.what());
        return 1;
    }
}
