// SPDX-License-Identifier: MIT
#include "output/words/comparison_text.hpp"

#include "core/text/printable.hpp"
#include "output/words/comparison_words.hpp"
#include "output/words/number_text.hpp"
#include "output/words/solution_text.hpp"
#include "output/words/tables/text_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt {

namespace {

constexpr int comparison_line_width = 110;
constexpr int objective_decimals = 6, peak_decimals = 4;

std::string limits_cell(const Comparison& comparison, const ComparisonRow& row) {
    if (!row.misfit.empty()) return "left out: " + row.misfit;
    const std::vector<std::string> broken = broken_limits(row);
    if (!broken.empty()) return fmt::format("{}", fmt::join(broken, "; "));
    if (row.limits.empty()) return "";
    if (row.is_optimum() && !row.feasible)
        return fmt::format("the solve is {}", name_of(comparison.optimum.certificate.verdict));
    return "kept";
}

TextTable table_of(const Comparison& comparison) {
    const bool bases = has_bases(comparison);
    TextTable table;
    const std::vector<PhysicalPeak> physical = physical_peaks(comparison);
    table.columns = {{"law", true}, {"objective"}, {"loss"}};
    for (const PhysicalPeak& peak : physical) table.columns.push_back({peak.title});
    for (const char* const symbol : {"V", "A", "J"}) table.columns.push_back({symbol});
    if (bases) table.columns.push_back({base_title(comparison)});
    table.columns.push_back({"limits", true});
    for (const ComparisonRow& row : comparison.rows) {
        std::vector<std::string> cells = {row_title(row)};
        if (row.misfit.empty()) {
            cells.insert(cells.end(), {fixed_text(row.objective, objective_decimals), loss_words(row)});
            for (const PhysicalPeak& peak : physical) cells.push_back(peak.text(row));
            cells.insert(cells.end(), {fixed_text(row.peaks.velocity.value, peak_decimals),
                                       fixed_text(row.peaks.acceleration.value, peak_decimals),
                                       fixed_text(row.peaks.jerk.value, peak_decimals)});
        } else {
            cells.insert(cells.end(), 5 + physical.size(), "");
        }
        if (bases) cells.push_back(base_words(comparison, row));
        cells.push_back(limits_cell(comparison, row));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

}  // namespace

std::string comparison_text(const Comparison& comparison) {
    const Solution& solution = comparison.optimum;
    std::string text;
    if (!solution.scene.title.empty()) text += printable(solution.scene.title) + "\n";
    text += verdict_sentence(solution) + "\n";
    if (!solution.motion) text += "What each limit would have to give: camopt solve.\n";
    for (const std::string& note : solution.notes) text += fmt::format("  note: {}\n", note);
    text += wrapped_text(comparison_sentence(comparison), "", comparison_line_width);
    text += "\n" + aligned_text(table_of(comparison));
    text += fmt::format("\nobjective: {}\n", objective_words(comparison));
    if (has_bases(comparison))
        text += wrapped_text(
            "the smallest base radius at which the motion keeps every limit, the cam's other dimensions as "
            "they are; none: no radius tried keeps them",
            base_title(comparison) + ": ", comparison_line_width);
    return text;
}

}  // namespace camopt
