// SPDX-License-Identifier: MIT
#include "output/chart/axis_ticks.hpp"
#include "output/chart/plot_frame.hpp"
#include "output/chart/studies/study_svg.hpp"
#include "output/chart/svg_canvas.hpp"
#include "output/view/number_text.hpp"
#include "output/words/solution_text.hpp"
#include "output/words/study_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>

namespace camopt {

namespace {

// Layout, px.
constexpr double bars_left = 292, bars_width = 330, bars_top = 170, row_height = 24, bar_height = 14;
constexpr double bars_right = bars_left + bars_width;
constexpr double column_width = 74, first_column = bars_right + 84, margin = 40;
constexpr double hatch_distance = 6;
// A bar ends here at the latest, in units of the least finite objective: one bad law must not flatten the
// rest.
constexpr double longest_bar = 3.0;
constexpr std::size_t most_letters = 52;  // of a remark

const char* page_style =
    ".best{font-weight:600;fill:#0072b2}.remark{font-size:11px;fill:#555}"
    ".optimum-bar{fill:#0072b2}.law-bar{fill:#8c8c8c}.broken-bar{fill:#f6f6f6;stroke:#b5b5b5}"
    ".hatch{fill:none;stroke:#b5b5b5;stroke-width:1.2}.cut{fill:none;stroke:#fff;stroke-width:3}"
    ".optimum-line{stroke:#0072b2;stroke-width:1.4;stroke-dasharray:5 3}";

struct Column {
    std::string title;
    std::function<std::string(const ComparisonRow&)> cell;
};

std::vector<Column> columns_of(const Comparison& comparison) {
    std::vector<Column> columns = {
        {"objective", [](const ComparisonRow& row) { return fixed_text(row.objective, 4); }},
        {"loss", [](const ComparisonRow& row) { return loss_words(row); }}};
    for (const PhysicalPeak& peak : physical_peaks(comparison))
        columns.push_back({peak.title, [peak](const ComparisonRow& row) { return peak.text(row); }});
    const std::vector<Column> normalised = {
        {"V", [](const ComparisonRow& row) { return fixed_text(row.peaks.velocity.value, 3); }},
        {"A", [](const ComparisonRow& row) { return fixed_text(row.peaks.acceleration.value, 3); }},
        {"J", [](const ComparisonRow& row) { return fixed_text(row.peaks.jerk.value, 2); }}};
    columns.insert(columns.end(), normalised.begin(), normalised.end());
    if (has_bases(comparison))
        columns.push_back(
            {base_title(comparison), [&](const ComparisonRow& row) { return base_words(comparison, row); }});
    return columns;
}

/// 45 degree lines inside a bar.
void draw_hatch(SvgCanvas& canvas, double left, double top, double width) {
    std::string path;
    const int lines = static_cast<int>((width + bar_height) / hatch_distance);
    for (int k = 1; k <= lines; ++k) {
        const double foot = left - bar_height + k * hatch_distance;
        const double from = std::max(foot, left), to = std::min(foot + bar_height, left + width);
        if (to <= from) continue;
        path += fmt::format("M{} {}L{} {}", svg_number(from), svg_number(top + bar_height - (from - foot)),
                            svg_number(to), svg_number(top + bar_height - (to - foot)));
    }
    if (!path.empty()) canvas.path(path, "hatch");
}

void draw_bar(SvgCanvas& canvas, const PlotAxis& axis, const ComparisonRow& row, double middle) {
    if (!row.misfit.empty()) {
        canvas.text(axis.begin + 6, middle + 4, "left out: " + row.misfit, "remark");
        return;
    }
    const double top = middle - 0.5 * bar_height;
    if (!std::isfinite(row.objective)) {
        canvas.text(axis.begin + 6, middle + 4, "∞", "value faint");
        return;
    }
    const bool cut = row.objective > axis.upper;
    const double width = axis.place(std::min(row.objective, axis.upper)) - axis.begin;
    const char* look = !row.feasible ? "broken-bar" : row.is_optimum() ? "optimum-bar" : "law-bar";
    canvas.rectangle(axis.begin, top, width, bar_height, look);
    if (!row.feasible) draw_hatch(canvas, axis.begin, top, width);
    if (!cut) return;
    const double x = axis.begin + width - 18;
    canvas.line(x, top + bar_height + 1, x + 8, top - 1, "cut");
}

std::string shortened(const std::string& words) {
    if (words.size() <= most_letters) return words;
    std::size_t end = words.rfind(' ', most_letters - 1);
    if (end == std::string::npos) end = most_letters - 1;
    return words.substr(0, end) + " …";
}

std::string remark_of(const ComparisonRow& row) {
    const std::vector<std::string> broken = broken_limits(row);
    if (broken.empty()) return {};
    const std::string more = broken.size() > 1 ? fmt::format("; {} more", broken.size() - 1) : "";
    return shortened(broken.front()) + more;
}

PlotAxis axis_of(const Comparison& comparison) {
    double least = infinity, most = 0.0;
    for (const ComparisonRow& row : comparison.rows) {
        if (!row.misfit.empty() || !std::isfinite(row.objective)) continue;
        least = std::min(least, row.objective);
        most = std::max(most, row.objective);
    }
    if (!(most > 0.0)) most = 1.0;
    if (least > 0.0 && std::isfinite(least)) most = std::min(most, longest_bar * least);
    return {0.0, 1.04 * most, bars_left, bars_right, false};
}

void draw_axis(SvgCanvas& canvas, const PlotAxis& axis, const Comparison& comparison, double bottom) {
    PlotFrame frame;
    frame.horizontal = axis;
    frame.vertical = {0.0, 1.0, bottom, bars_top, false};
    frame.horizontal_ticks = labelled_ticks(axis.lower, axis.upper, 5);
    frame.horizontal_title = "objective";
    draw_plot_frame(canvas, frame);
    const auto fitting = static_cast<double>(
        std::ranges::count_if(comparison.rows, [](const ComparisonRow& row) { return row.misfit.empty(); }));
    for (const ComparisonRow& row : comparison.rows) {
        if (!row.is_optimum() || !axis.holds(row.objective)) continue;
        const double x = axis.place(row.objective);
        canvas.line(x, bars_top, x, bars_top + row_height * fitting, "optimum-line");
    }
}

void draw_row(SvgCanvas& canvas, const ComparisonRow& row, const std::vector<Column>& columns,
              double middle) {
    const std::string look = row.is_optimum() ? "value right best"
                             : row.feasible   ? "value right"
                                              : "value right faint";
    canvas.text(bars_left - 12, middle + 4, row_title(row), look);
    double x = first_column;
    for (const Column& column : columns) {
        if (row.misfit.empty()) canvas.text(x, middle + 4, column.cell(row), look);
        x += column_width;
    }
    canvas.text(x - column_width + 18, middle + 4, remark_of(row), "remark");
}

void draw_key(SvgCanvas& canvas, bool limits) {
    const double y = 130;
    canvas.rectangle(margin, y - 11, 24, bar_height, "optimum-bar");
    canvas.text(margin + 31, y, "optimum", "subtitle");
    canvas.rectangle(margin + 120, y - 11, 24, bar_height, "law-bar");
    canvas.text(margin + 151, y, limits ? "law, satisfies every limit" : "law", "subtitle");
    if (!limits) return;
    canvas.rectangle(margin + 330, y - 11, 24, bar_height, "broken-bar");
    draw_hatch(canvas, margin + 330, y - 11, 24);
    canvas.text(margin + 361, y, "law, violates a limit (the worst is named)", "subtitle");
}

}  // namespace

std::string comparison_svg(const Comparison& comparison) {
    const Solution& solution = comparison.optimum;
    const std::vector<Column> columns = columns_of(comparison);
    const double bottom = bars_top + row_height * static_cast<double>(comparison.rows.size());
    const bool remarks =
        std::ranges::any_of(comparison.rows, [](const auto& row) { return !remark_of(row).empty(); });
    const bool limits =
        std::ranges::any_of(comparison.rows, [](const auto& row) { return !row.limits.empty(); });
    const double remark_left = first_column + column_width * static_cast<double>(columns.size() - 1) + 18;
    const double width = remarks ? remark_left + 400 : std::max(remark_left + 22, 1000.0);
    const std::string title = solution.scene.title.empty() ? "Comparison of laws" : solution.scene.title;
    SvgCanvas canvas(width, bottom + 56, page_style, title);
    canvas.rectangle(0, 0, width, bottom + 56, "page");
    canvas.text(margin, 38, title, "title");
    canvas.text(margin, 61, verdict_sentence(solution), "subtitle");
    canvas.text(margin, 80, comparison_sentence(comparison), "subtitle");
    canvas.text(margin, 99, "Objective = " + objective_words(comparison), "subtitle");
    draw_key(canvas, limits);
    const PlotAxis axis = axis_of(comparison);
    draw_axis(canvas, axis, comparison, bottom);
    double x = first_column;
    for (const Column& column : columns) {
        canvas.text(x, bars_top - 8, column.title, "head");
        x += column_width;
    }
    double middle = bars_top + 0.5 * row_height;
    for (const ComparisonRow& row : comparison.rows) {
        draw_bar(canvas, axis, row, middle);
        draw_row(canvas, row, columns, middle);
        middle += row_height;
    }
    return canvas.finish();
}

}  // namespace camopt
