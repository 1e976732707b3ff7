// SPDX-License-Identifier: MIT
#include "output/chart/reference_table/reference_table_svg.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "output/chart/axis_ticks.hpp"
#include "output/chart/plot_frame.hpp"
#include "output/view/number_text.hpp"
#include "output/words/study_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace camopt {

namespace {

// Layout, px.
constexpr double page_width = 1160, page_height = 1004;
constexpr PanelFrame convergence_place{84, 120, 480, 392}, acceleration_place{668, 120, 452, 170},
    jerk_place{668, 342, 452, 170}, law_place{40, 632, 1080, 330};

const SplineCurve* best_curve(const ReferenceTable& table) {
    for (const ConvergenceRow& row : table.convergence)
        if (row.segments == 12 && row.optimum.curve) return &*row.optimum.curve;
    return nullptr;
}

void draw_curves(SvgCanvas& canvas, const SplineCurve& best) {
    const auto law = make_law("modified_sine");
    const double left = acceleration_place.left, above = acceleration_place.top - 12;
    canvas.text(left, above, "Acceleration y″", "caption");
    canvas.text(left, jerk_place.top - 12, "Jerk y‴", "caption");
    canvas.line(left + 150, above - 4, left + 176, above - 4, "best-line");
    canvas.text(left + 182, above, "best cubic, 12 segments", "value");
    canvas.line(left + 350, above - 4, left + 376, above - 4, "law-line");
    canvas.text(left + 382, above, "mod. sine", "value");
    draw_curve_panel(canvas, acceleration_place, 2, {best, *law});
    draw_curve_panel(canvas, jerk_place, 3, {best, *law});
}

// The objectives of interest lie here; n = 4 lies far above and is named with an arrow.
constexpr double objective_lower = 0.93, objective_upper = 1.0;

PlotFrame convergence_frame(const PanelFrame& place, const ReferenceTable& table) {
    PlotFrame frame;
    frame.horizontal = {3.6, 72.0, place.left, place.left + place.width, true};
    frame.vertical = {objective_lower, objective_upper, place.top + place.height, place.top, false};
    for (const ConvergenceRow& row : table.convergence)
        frame.horizontal_ticks.push_back({static_cast<double>(row.segments), std::to_string(row.segments)});
    for (const double value : round_ticks(objective_lower, objective_upper, 7))
        frame.vertical_ticks.push_back({value, tick_text(value, 0.01)});
    frame.horizontal_title = "number of equal segments n";
    frame.vertical_title = "objective (smaller is better)";
    return frame;
}

void draw_diamond(SvgCanvas& canvas, double x, double y, double size) {
    canvas.path(fmt::format("M{} {}l{} {}l{} {}l{} {}Z", svg_number(x), svg_number(y - size), size, size,
                            -size, size, -size, -size),
                "paper");
}

void draw_optimum(SvgCanvas& canvas, const PlotFrame& frame, const ConvergenceRow& row) {
    const Certificate& certificate = row.optimum.certificate;
    const double x = frame.horizontal.place(row.segments);
    if (!std::isfinite(certificate.objective)) {
        canvas.text(x, frame.vertical.end + 18, "failed", "unproved middle");
        return;
    }
    if (!frame.vertical.holds(certificate.objective)) {
        canvas.path(fmt::format("M{} {}l-5 9h10Z", svg_number(x), svg_number(frame.vertical.end + 4)),
                    "optimum-dot");
        const std::string printed =
            row.printed ? ", the paper " + fixed_text(row.printed->objective, 4) : std::string{};
        canvas.text(x + 12, frame.vertical.end + 14, fixed_text(certificate.objective, 4) + printed, "value");
        return;
    }
    const bool proved = certificate.verdict == Verdict::optimal;
    canvas.circle(x, frame.vertical.place(certificate.objective), 4.5,
                  proved ? "optimum-dot" : "unproved-dot");
}

void draw_convergence_legend(SvgCanvas& canvas, double x, double y) {
    canvas.circle(x, y - 4, 4.5, "optimum-dot");
    canvas.text(x + 14, y, "optimum, proved", "value");
    draw_diamond(canvas, x, y + 16, 6);
    canvas.text(x + 14, y + 20, "the paper, as printed (1994)", "value");
    canvas.line(x - 8, y + 36, x + 8, y + 36, "limit-line");
    canvas.text(x + 14, y + 40, "lower bound for every curve", "value");
}

constexpr double name_width = 238, objective_width = 104, column_gap = 34;

struct PeakBars {
    std::string name;
    std::array<double, 3> ratio{};  ///< V, A, J over those of the modified sine
    double objective = 0.0;
    bool best = false;
};

std::array<double, 3> ratios(const PeakFigures& figures, const PeakFigures& base) {
    return {figures.velocity / base.velocity, figures.acceleration / base.acceleration,
            figures.jerk / base.jerk};
}

std::vector<PeakBars> bars_of(const ReferenceTable& table) {
    std::vector<PeakBars> bars;
    const PeakFigures& base = table.modified_sine_exact;
    for (const ConvergenceRow& row : table.convergence) {
        const std::optional<PeakFigures> figures = optimum_figures(row.optimum);
        if (row.segments == 12 && figures)
            bars.push_back({"best cubic, 12 segments", ratios(*figures, base), figures->objective, true});
    }
    for (const LawComparisonRow& law : table.laws)
        if (law.exact) bars.push_back({law.name, ratios(*law.exact, base), law.exact->objective, false});
    std::ranges::stable_sort(bars, {}, &PeakBars::objective);
    return bars;
}

PlotAxis ratio_axis(const std::vector<PeakBars>& bars, std::size_t peak, double left, double width) {
    double lower = 0.9, upper = 1.1;
    for (const PeakBars& row : bars) {
        if (!std::isfinite(row.ratio[peak])) continue;
        lower = std::min(lower, row.ratio[peak]);
        upper = std::max(upper, row.ratio[peak]);
    }
    const double margin = 0.06 * (upper - lower);
    return {lower - margin, upper + margin, left, left + width, false};
}

void draw_mark(SvgCanvas& canvas, const PlotAxis& axis, const PeakBars& row, std::size_t peak, double y) {
    const double ratio = row.ratio[peak];
    if (!std::isfinite(ratio)) {
        canvas.text(axis.end - 8, y + 4, "∞", "value right");
        return;
    }
    canvas.line(axis.place(1.0), y, axis.place(ratio), y, row.best ? "best-stem" : "stem");
    canvas.circle(axis.place(ratio), y, 4.5, row.best ? "optimum-dot" : "law-dot");
}

void draw_column(SvgCanvas& canvas, const PanelFrame& area, const std::vector<PeakBars>& bars,
                 std::size_t peak) {
    static constexpr std::array<const char*, 3> titles = {"velocity V", "acceleration A", "jerk J"};
    PlotFrame frame;
    frame.horizontal = ratio_axis(bars, peak, area.left, area.width);
    frame.vertical = {0.0, 1.0, area.top + area.height, area.top, false};
    frame.horizontal_ticks = labelled_ticks(frame.horizontal.lower, frame.horizontal.upper, 4);
    draw_plot_frame(canvas, frame);
    canvas.text(area.left + 0.5 * area.width, area.top - 8, titles[peak], "axis-title");
    const double one = frame.horizontal.place(1.0);
    canvas.line(one, area.top, one, area.top + area.height, "zero");
    const double step = area.height / static_cast<double>(bars.size());
    for (std::size_t i = 0; i < bars.size(); ++i)
        draw_mark(canvas, frame.horizontal, bars[i], peak, area.top + (static_cast<double>(i) + 0.5) * step);
}

}  // namespace

std::string reference_table_svg(const ReferenceTable& table) {
    SvgCanvas canvas(page_width, page_height, reference_panel_style(),
                     "The best cubic spline and the modified sine");
    canvas.rectangle(0, 0, page_width, page_height, "page");
    canvas.text(40, 42, "The best cubic spline and the modified sine", "title");
    canvas.text(40, 66,
                "Rise between two dwells. Objective = 0.4 V/1.76 + 0.4 A/5.53 + 0.2 J/69, with V, A, J = max "
                "|y′|, |y″|, |y‴|.",
                "subtitle");
    const std::string warning = unproved_warning(table);
    if (!warning.empty()) canvas.text(40, 88, warning, "unproved");
    canvas.text(convergence_place.left, convergence_place.top - 12,
                "Objective against the number of segments", "caption");
    draw_convergence_panel(canvas, convergence_place, table);
    if (const SplineCurve* best = best_curve(table)) draw_curves(canvas, *best);
    canvas.text(40, law_place.top - 36,
                "Peaks relative to the modified sine (1 = as large), sorted by the objective", "caption");
    draw_law_panel(canvas, law_place, table);
    return canvas.finish();
}

std::string_view reference_panel_style() {
    return ".optimum-line{fill:none;stroke:#0072b2;stroke-width:1;opacity:.45}.optimum-dot{fill:#0072b2}"
           ".unproved-dot{fill:#fff;stroke:#c00000;stroke-width:2}.unproved{fill:#c00000;font-size:12px}"
           ".paper{fill:none;stroke:#d55e00;stroke-width:1.8}"
           ".limit-line{stroke:#009e73;stroke-width:1.8;stroke-dasharray:6 4}"
           ".value{font-size:12px;fill:#222}.value.right{text-anchor:end}.middle{text-anchor:middle}"
           ".limit-value{font-size:12px;fill:#00704f;text-anchor:end}.best-name{font-weight:600;fill:#0072b2}"
           ".law-line{fill:none;stroke:#666;stroke-width:1.6;stroke-dasharray:5 3}"
           ".best-line{fill:none;stroke:#0072b2;stroke-width:2;stroke-linejoin:round}"
           ".zero{stroke:#999;stroke-width:1}.stem{stroke:#9a9a9a;stroke-width:3}.law-dot{fill:#666}"
           ".best-stem{stroke:#0072b2;stroke-width:3}.caption{font-size:14px;font-weight:600;fill:#111}";
}

void draw_convergence_panel(SvgCanvas& canvas, const PanelFrame& place, const ReferenceTable& table) {
    const PlotFrame frame = convergence_frame(place, table);
    draw_plot_frame(canvas, frame);
    const double limit = frame.vertical.place(table.limit.objective);
    if (frame.vertical.holds(table.limit.objective)) {
        canvas.line(place.left, limit, place.left + place.width, limit, "limit-line");
        canvas.text(place.left + place.width - 6, limit + 16, fixed_text(table.limit.objective, 6),
                    "limit-value");
    }
    std::string line;
    for (const ConvergenceRow& row : table.convergence) {
        const double objective = row.optimum.certificate.objective;
        if (!frame.vertical.holds(objective)) continue;
        line +=
            fmt::format("{}{} {}", line.empty() ? "M" : "L", svg_number(frame.horizontal.place(row.segments)),
                        svg_number(frame.vertical.place(objective)));
    }
    if (!line.empty()) canvas.path(line, "optimum-line");
    for (const ConvergenceRow& row : table.convergence) {
        draw_optimum(canvas, frame, row);
        if (row.printed && frame.vertical.holds(row.printed->objective))
            draw_diamond(canvas, frame.horizontal.place(row.segments),
                         frame.vertical.place(row.printed->objective), 7);
    }
    draw_convergence_legend(canvas, place.left + place.width - 196, place.top + 24);
}

void draw_curve_panel(SvgCanvas& canvas, const PanelFrame& place, int order, const CurvePair& pair) {
    const ValueRange best = value_range(pair.optimum, order), law = value_range(pair.law, order);
    const double top = 1.12 * std::max(best.upper, law.upper),
                 bottom = 1.12 * std::min(best.lower, law.lower);
    PlotFrame frame;
    frame.horizontal = {0.0, 1.0, place.left, place.left + place.width, false};
    frame.vertical = {bottom, top, place.top + place.height, place.top, false};
    frame.horizontal_ticks = labelled_ticks(0.0, 1.0, 5);
    frame.vertical_ticks = labelled_ticks(bottom, top, 5);
    if (order == 3) frame.horizontal_title = "x = cam angle / rise";
    draw_plot_frame(canvas, frame);
    const double zero = frame.vertical.place(0.0);
    canvas.line(place.left, zero, place.left + place.width, zero, "zero");
    const PlotMap map{[&](double x) { return frame.horizontal.place(x); },
                      [&](double value) { return frame.vertical.place(value); }};
    canvas.path(curve_path(pair.law, order, map), "law-line");
    canvas.path(curve_path(pair.optimum, order, map), "best-line");
}

void draw_law_panel(SvgCanvas& canvas, const PanelFrame& place, const ReferenceTable& table) {
    const std::vector<PeakBars> bars = bars_of(table);
    if (bars.empty()) return;
    const double step = place.height / static_cast<double>(bars.size());
    const double right = place.left + place.width;
    canvas.text(right, place.top - 8, "objective", "value right");
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const double y = place.top + (static_cast<double>(i) + 0.5) * step + 4;
        const char* name = bars[i].best ? "value right best-name" : "value right";
        canvas.text(place.left + name_width - 12, y, bars[i].name, name);
        canvas.text(right, y, fixed_text(bars[i].objective, 4), name);
    }
    const double width = (place.width - name_width - objective_width - 2 * column_gap) / 3;
    for (std::size_t peak = 0; peak < 3; ++peak) {
        const double left = place.left + name_width + static_cast<double>(peak) * (width + column_gap);
        draw_column(canvas, {left, place.top, width, place.height}, bars, peak);
    }
}

}  // namespace camopt
