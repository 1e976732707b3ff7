// SPDX-License-Identifier: MIT
#include "motions/laws/law_catalogue.hpp"
#include "output/chart/chart.hpp"
#include "output/chart/studies/study_svg.hpp"
#include "output/view/number_text.hpp"
#include "output/words/study_text.hpp"

#include <fmt/format.h>

#include <iterator>

namespace camopt {

namespace {

// The objectives of interest lie here; n = 4 lies far above and is named.
constexpr double objective_lower = 0.93, objective_upper = 1.0;
constexpr int best_segments = 12;
constexpr double row_height = 16;  // px

ChartPanel convergence_panel(const ReferenceTable& table) {
    ChartPanel panel{.width = 470, .height = 400, .caption = "Objective against the number of segments"};
    panel.frame.horizontal = {3.6, 72.0, 0.0, 1.0, true};
    panel.frame.vertical = {objective_lower, objective_upper};
    panel.frame.horizontal_title = "number of equal segments n";
    panel.frame.vertical_title = "objective (smaller is better)";
    ChartSeries line{Look::line, "row-line"}, optima{Look::dot, "optimum-dot", {}, 4.5, "optimum, proved"},
        printed{Look::diamond, "printed", {}, 7, "the paper, as printed (1994)"},
        words{Look::label, "", {}, 0.0, "", "value"};
    for (const ConvergenceRow& row : table.convergence) {
        const Certificate& certificate = row.optimum.certificate;
        const double n = row.segments, objective = certificate.objective;
        panel.frame.horizontal_ticks.push_back({n, std::to_string(row.segments)});
        line.points.push_back({n, objective});
        optima.points.push_back({n, objective, certificate.verdict == Verdict::optimal ? "" : "unproved"});
        if (row.printed) printed.points.push_back({n, row.printed->objective});
        if (panel.frame.vertical.holds(objective)) continue;
        const std::string paper = row.printed ? ", the paper " + fixed_text(row.printed->objective, 4) : "";
        words.points.push_back(
            {n, objective_upper, "",
             std::isfinite(objective) ? "▲ " + fixed_text(objective, 4) + paper : std::string("failed")});
    }
    const double bound = table.limit.objective;
    ChartSeries limit{Look::line,
                      "limit-line",
                      {{3.6, bound, "", fixed_text(bound, 6)}, {72.0, bound}},
                      0.0,
                      "lower bound for every curve",
                      "limit-line-label",
                      LabelSide::above};
    panel.series = {std::move(line), std::move(optima), std::move(printed), std::move(limit),
                    std::move(words)};
    return panel;
}

/// A derivative with both values of its steps; a point where it is infinite breaks the line.
ChartSeries motion_series(const Motion& motion, std::size_t order, const char* css, const char* title) {
    constexpr double points_over_all = 360;
    ChartSeries series{Look::line, css, {}, 0.0, title};
    const std::vector<double> breakpoints = motion.breakpoints();
    const double length = motion.end() - motion.begin();
    const auto add = [&](const MotionPoint& point) {
        series.points.push_back({point.x, point.derivative[order]});
    };
    for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
        const double left = breakpoints[i], right = breakpoints[i + 1];
        const int steps = std::max(2, static_cast<int>(std::ceil(points_over_all * (right - left) / length)));
        add(motion.at(left, Side::right));
        for (int k = 1; k < steps; ++k) add(motion.at(left + (right - left) * k / steps));
        add(motion.at(right, Side::left));
    }
    return series;
}

ChartPanel curve_panel(const Motion& optimum, const Motion& law, std::size_t order) {
    const bool jerk = order == 3;
    ChartPanel panel{.place = jerk ? ChartPanel::Place::below : ChartPanel::Place::right,
                     .width = 450,
                     .height = 171,
                     .caption = jerk ? "Jerk y‴" : "Acceleration y″",
                     .series = {motion_series(law, order, "law-line", "modified sine"),
                                motion_series(optimum, order, "best-line", "best cubic, 12 segments")}};
    panel.frame.horizontal = {0.0, 1.0};
    if (jerk) panel.frame.horizontal_title = "x = cam angle / rise";
    return panel;
}

/// The best of 12 segments is the one without a key.
std::vector<LawComparisonRow> laws_by_objective(const ReferenceTable& table) {
    std::vector<LawComparisonRow> laws;
    for (const ConvergenceRow& row : table.convergence)
        if (const std::optional<PeakFigures> figures = optimum_figures(row.optimum);
            row.segments == best_segments && figures)
            laws.push_back({"best cubic, 12 segments", "", {}, figures, {}});
    std::ranges::copy_if(table.laws, std::back_inserter(laws),
                         [](const LawComparisonRow& law) { return law.exact.has_value(); });
    std::ranges::stable_sort(laws, {}, [](const LawComparisonRow& law) { return law.exact->objective; });
    return laws;
}

/// A peak over that of the modified sine, as dots on stems that begin at 1.
ChartPanel ratio_panel(const std::vector<LawComparisonRow>& laws, const char* caption,
                       double PeakFigures::*peak, const PeakFigures& base) {
    ChartPanel panel{
        .place = ChartPanel::Place::right, .width = 226, .caption = caption, .row_height = row_height};
    ChartSeries dots{Look::dot, "law-dot", {}, 4.5},
        infinite{Look::label, "", {}, 0.0, "", "value", LabelSide::beside};
    for (const LawComparisonRow& law : laws) {
        const double ratio = (*law.exact).*peak / base.*peak, y = -0.5 - panel.rows++;
        panel.series.push_back(
            {Look::line, law.key.empty() ? "optimum-stem" : "law-stem", {{1.0, y}, {ratio, y}}});
        dots.points.push_back({ratio, y, law.key.empty() ? "optimum-dot" : ""});
        if (!std::isfinite(ratio)) infinite.points.push_back({1.0, y, "", "∞"});
    }
    panel.series.push_back({Look::rule, "zero", {{1.0, 0.0}}});
    panel.series.push_back(std::move(dots));
    set_axes(panel);
    for (ChartPoint& point : infinite.points) point.x = panel.frame.horizontal.upper;
    panel.series.push_back(std::move(infinite));
    return panel;
}

/// One row a law: names, the ratios of three peaks, objectives.
void add_laws(Chart& chart, const ReferenceTable& table) {
    const std::vector<LawComparisonRow> laws = laws_by_objective(table);
    if (laws.empty()) return;
    ChartColumn names{""}, objectives{"objective"};
    for (const LawComparisonRow& law : laws) {
        const char* css = law.key.empty() ? "value best" : "value";
        names.cells.push_back({law.name, css});
        objectives.cells.push_back({fixed_text(law.exact->objective, 4), css});
    }
    const PeakFigures& base = table.modified_sine_exact;
    ChartPanel left{.caption = "Peaks relative to the modified sine (1 = as large), sorted by the objective",
                    .columns = {std::move(names)},
                    .row_height = row_height},
        right{
            .place = ChartPanel::Place::right, .columns = {std::move(objectives)}, .row_height = row_height};
    chart.panels.push_back(std::move(left));
    chart.panels.push_back(ratio_panel(laws, "velocity V", &PeakFigures::velocity, base));
    chart.panels.push_back(ratio_panel(laws, "acceleration A", &PeakFigures::acceleration, base));
    chart.panels.push_back(ratio_panel(laws, "jerk J", &PeakFigures::jerk, base));
    chart.panels.push_back(std::move(right));
}

}  // namespace

std::string reference_table_svg(const ReferenceTable& table) {
    Chart chart{
        "The best cubic spline and the modified sine",
        {"Rise between two dwells. Objective = 0.4 V/1.76 + 0.4 A/5.53 + 0.2 J/69, with V, A, J = max "
         "|y′|, |y″|, |y‴|."},
        unproved_warning(table)};
    chart.panels.push_back(convergence_panel(table));
    for (const ConvergenceRow& row : table.convergence) {
        if (row.segments != best_segments || !row.optimum.curve) continue;
        const auto law = make_law("modified_sine");
        for (const std::size_t order : {2U, 3U})
            chart.panels.push_back(curve_panel(*row.optimum.curve, *law, order));
    }
    add_laws(chart, table);
    return chart_svg(std::move(chart));
}

}  // namespace camopt
