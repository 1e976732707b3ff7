// SPDX-License-Identifier: MIT
#include "output/words/study_text.hpp"

#include <fmt/format.h>

#include <cctype>

namespace camopt {

namespace {

using Row = std::vector<std::string>;

constexpr int row_peak_decimals = 7;
constexpr int row_objective_decimals = 9;

std::string percent_above(double value, double base) {
    if (!std::isfinite(value) || !(base > 0.0)) return "–";
    return fmt::format("{:.3f} %", 100.0 * (value / base - 1.0));
}

std::string capitals(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
    return text;
}

struct Decimals {
    int velocity, acceleration, jerk, objective;
};

/// n, what, V, A, J, objective.
Row figures_row(const std::string& segments, const std::string& what,
                const std::optional<PeakFigures>& figures, const Decimals& decimals) {
    if (!figures) return {segments, what, "–", "–", "–", "–"};
    return {segments,
            what,
            fixed_text(figures->velocity, decimals.velocity),
            fixed_text(figures->acceleration, decimals.acceleration),
            fixed_text(figures->jerk, decimals.jerk),
            fixed_text(figures->objective, decimals.objective)};
}

void add_convergence_rows(TextTable& table, const ConvergenceRow& row, double limit) {
    constexpr Decimals printed_digits{3, 3, 2, 4}, exact_digits{4, 4, 4, 6};
    constexpr Decimals optimum_digits{row_peak_decimals, row_peak_decimals, row_peak_decimals,
                                      row_objective_decimals};
    std::string segments = fmt::format("{}", row.segments);
    const auto add = [&](const char* what, const std::optional<PeakFigures>& figures,
                         const Decimals& digits) {
        table.rows.push_back(figures_row(segments, what, figures, digits));
        segments.clear();
    };
    if (row.printed) add("paper, as printed", row.printed, printed_digits);
    if (row.points_exact) add("its points, exactly", row.points_exact, exact_digits);
    if (row.corrected_exact) add("misprint corrected", row.corrected_exact, exact_digits);
    add("optimum", optimum_figures(row.optimum), optimum_digits);
    table.rows.back().push_back(percent_above(row.optimum.certificate.objective, limit));
    table.rows.back().push_back(verdict_text(row.optimum.certificate));
}

TableSection convergence_section(const ReferenceTable& table) {
    TableSection section{
        "Peaks and objective against the number of segments n (the paper's Tables 1 and 2)",
        "Objective = 0.4 V/1.76 + 0.4 A/5.53 + 0.2 J/69; V, A, J are the largest |y'|, |y''|, |y'''|.",
        {{{"n"}, {"figures", true}, {"V"}, {"A"}, {"J"}, {"objective"}, {"above limit"}, {"verdict", true}},
         {}}};
    for (const ConvergenceRow& row : table.convergence)
        add_convergence_rows(section.table, row, table.limit.objective);
    const LimitCurve& limit = table.limit;
    section.table.rows.push_back({"∞", "limit of all curves", fixed_text(limit.velocity, row_peak_decimals),
                                  fixed_text(limit.acceleration, row_peak_decimals),
                                  fixed_text(limit.jerk, row_peak_decimals),
                                  fixed_text(limit.objective, row_objective_decimals)});
    return section;
}

/// y_1 … y_{n/2}; the rest follows by symmetry.
Row points_row(const std::string& segments, const std::string& what, const std::vector<double>& ordinates) {
    Row row = {segments, what};
    for (std::size_t i = 1; i <= (ordinates.size() - 1) / 2; ++i) row.push_back(fixed_text(ordinates[i], 6));
    return row;
}

TableSection points_section(const ReferenceTable& table) {
    TableSection section{"Optimum points (the paper's Table 1)",
                         "y at x = i/n, first half; the second follows from y(x) + y(1 − x) = 1.",
                         {{{"n"}, {"figures", true}}, {}}};
    std::size_t most = 0;
    for (const ConvergenceRow& row : table.convergence) {
        if (row.printed_points.empty()) continue;
        section.table.rows.push_back(
            points_row(fmt::format("{}", row.segments), "paper", row.printed_points));
        if (row.optimum_points.empty())
            section.table.rows.push_back({"", verdict_text(row.optimum.certificate)});
        else
            section.table.rows.push_back(points_row("", "optimum", row.optimum_points));
        most = std::max(most, (row.printed_points.size() - 1) / 2);
    }
    for (std::size_t i = 1; i <= most; ++i) section.table.columns.push_back({fmt::format("y{}", i)});
    return section;
}

TableSection laws_section(const ReferenceTable& table) {
    TableSection section{
        "The classical laws (the paper's Table 3)",
        "Above optimum: by how much a law's objective exceeds that of the best cubic spline of 12 segments.",
        {{{"law", true},
          {"printed V"},
          {"A"},
          {"J"},
          {"exact V"},
          {"A"},
          {"J"},
          {"objective"},
          {"above optimum"}},
         {}}};
    for (const LawComparisonRow& law : table.laws) {
        Row row = {law.name, "", "", ""};
        if (law.printed)
            row = {law.name, fixed_text(law.printed->velocity, 2), fixed_text(law.printed->acceleration, 2),
                   fixed_text(law.printed->jerk, 0)};
        if (law.exact) {
            row.push_back(fixed_text(law.exact->velocity, 4));
            row.push_back(fixed_text(law.exact->acceleration, 4));
            row.push_back(fixed_text(law.exact->jerk, 3));
            row.push_back(fixed_text(law.exact->objective, 5));
            row.push_back(law.loss_percent ? fmt::format("{:.2f} %", *law.loss_percent) : "–");
        }
        section.table.rows.push_back(std::move(row));
    }
    return section;
}

TableSection weights_section(const ReferenceTable& table) {
    TableSection section{
        "The effect of the weights, n = 10 (the paper's Table 4)",
        "y4 of the paper's search and of the optimum; objectives under the row's own weights.",
        {{{"V"},
          {"A"},
          {"J"},
          {"y4 printed"},
          {"y4 optimum"},
          {"paper's peaks"},
          {"optimum"},
          {"limit"},
          {"verdict", true}},
         {}}};
    for (const WeightEffectRow& row : table.weights) {
        const bool solved = row.optimum.curve.has_value();
        section.table.rows.push_back(
            {fixed_text(row.velocity, 3), fixed_text(row.acceleration, 3), fixed_text(row.jerk, 3),
             fixed_text(row.printed_fourth_ordinate, 6),
             solved ? fixed_text(row.fourth_ordinate, 6) : std::string("–"),
             fixed_text(row.printed_objective, 6),
             solved ? fixed_text(row.optimum.certificate.objective, row_objective_decimals)
                    : std::string("–"),
             fixed_text(row.limit.objective, row_objective_decimals), verdict_text(row.optimum.certificate)});
    }
    return section;
}

}  // namespace

std::optional<PeakFigures> optimum_figures(const Solution& solution) {
    if (!solution.curve) return {};
    return PeakFigures{solution.peaks.velocity.value, solution.peaks.acceleration.value,
                       solution.peaks.jerk.value, solution.certificate.objective};
}

std::string verdict_text(const Certificate& certificate) {
    const std::string gap = certificate.gap ? fmt::format("gap {:.1e}", *certificate.gap) : "no bound";
    if (certificate.verdict == Verdict::optimal) return fmt::format("optimal, {}", gap);
    const std::string reason =
        certificate.reason == Reason::none ? gap : fmt::format("{}, {}", name_of(certificate.reason), gap);
    return fmt::format("NOT PROVED OPTIMAL: {} ({})", capitals(name_of(certificate.verdict)), reason);
}

std::vector<std::string> unproved_rows(const ReferenceTable& table) {
    std::vector<std::string> rows;
    const auto look = [&](const std::string& name, const Certificate& certificate) {
        if (certificate.verdict == Verdict::optimal) return;
        const std::string reason =
            certificate.reason == Reason::none ? "" : fmt::format(": {}", name_of(certificate.reason));
        rows.push_back(fmt::format("{} ({}{})", name, name_of(certificate.verdict), reason));
    };
    for (const ConvergenceRow& row : table.convergence)
        look(fmt::format("n = {}", row.segments), row.optimum.certificate);
    for (const WeightEffectRow& row : table.weights)
        look(fmt::format("weights {:.3g}, {:.3g}, {:.3g}", row.velocity, row.acceleration, row.jerk),
             row.optimum.certificate);
    return rows;
}

std::string unproved_warning(const ReferenceTable& table) {
    const std::vector<std::string> rows = unproved_rows(table);
    return rows.empty() ? "" : fmt::format("Not proved optimal: {}.", fmt::join(rows, "; "));
}

std::vector<TableSection> reference_table_sections(const ReferenceTable& table) {
    return {convergence_section(table), points_section(table), laws_section(table), weights_section(table)};
}

}  // namespace camopt
