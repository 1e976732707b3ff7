// SPDX-License-Identifier: MIT
#include "output/chart/reference_table/reference_table_panels.hpp"

#include "output/chart/axis_ticks.hpp"
#include "output/chart/curve_path.hpp"
#include "output/chart/plot_frame.hpp"
#include "output/words/tables/reference_table_rows.hpp"
#include "output/words/tables/text_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt {

namespace {

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
    canvas.text(x + 14, y + 40, "limit no curve can pass", "value");
}

}  // namespace

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

}  // namespace camopt
