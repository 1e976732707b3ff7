// SPDX-License-Identifier: MIT
#include "output/csv/comparison_csv.hpp"

#include "core/units.hpp"
#include "output/csv/csv_line.hpp"
#include "output/words/comparison_words.hpp"
#include "scene/cost_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace camopt {

namespace {

/// The limits of the scene, from the first row that has been judged.
std::vector<std::string> limit_keys(const Comparison& comparison) {
    std::vector<std::string> keys;
    const auto judged =
        std::ranges::find_if(comparison.rows, [](const auto& row) { return row.misfit.empty(); });
    if (judged == comparison.rows.end()) return keys;
    for (const LimitOutcome& outcome : judged->limits) keys.push_back(outcome.reached.key);
    return keys;
}

void add_figures(CsvLine& line, const ComparisonRow& row, std::size_t limits) {
    if (!row.misfit.empty()) {
        line.blank(2 + cost_figure_count + static_cast<int>(limits));
        return;
    }
    line.number(row.objective).number(row.loss_percent);
    for (const CostTerm& term : cost_terms()) line.number(term.measured.of(row.peaks));
    for (const LimitOutcome& outcome : row.limits) {
        const double worst = outcome.reached.worst;
        line.number(outcome.reached.no_contact || std::isnan(worst) ? std::nullopt : std::optional(worst));
    }
}

}  // namespace

std::string comparison_csv(const Comparison& comparison) {
    const std::vector<std::string> keys = limit_keys(comparison);
    CsvLine titles;
    for (const char* title : {"law", "title", "fits", "feasible", "objective", "loss_percent"})
        titles.words(title);
    for (const CostTerm& term : cost_terms()) titles.words(term.name());
    for (const std::string& key : keys) titles.words(key);
    for (const char* title : {"base_radius_needed_mm", "broken", "note"}) titles.words(title);
    std::string text = titles.finish();
    for (const ComparisonRow& row : comparison.rows) {
        CsvLine line;
        line.words(row.key)
            .words(row_title(row))
            .count(row.misfit.empty() ? 1 : 0)
            .count(row.feasible ? 1 : 0);
        add_figures(line, row, keys.size());
        const bool has_radius = row.base && row.base->radius;
        line.number(has_radius ? std::optional(*row.base->radius / units::millimetre) : std::nullopt);
        line.words(fmt::format("{}", fmt::join(broken_limits(row), "; ")));
        std::string note = row.misfit;
        if (row.base && !row.base->radius) note = "no base radius tried helps: " + row.base->broken;
        text += line.words(note).finish();
    }
    return text;
}

}  // namespace camopt
