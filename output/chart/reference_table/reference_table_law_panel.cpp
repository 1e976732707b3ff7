// SPDX-License-Identifier: MIT
#include "output/chart/axis_ticks.hpp"
#include "output/chart/plot_frame.hpp"
#include "output/chart/reference_table/reference_table_panels.hpp"
#include "output/words/tables/reference_table_rows.hpp"
#include "output/words/tables/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace camopt {

namespace {

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
