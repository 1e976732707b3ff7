// SPDX-License-Identifier: MIT
#include "benchmarks/error_against_time_svg.hpp"

#include "output/plot_frame.hpp"
#include "output/svg_canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace camopt::benchmarks {

namespace {

// Layout, px.
constexpr double page_width = 1120, page_height = 940, panel_width = 440, panel_height = 290;
// Below this the error is rounding of the objective itself; such marks stand on the lowest line.
constexpr double least_error = 1e-15, most_error = 1.0;
constexpr double least_seconds = 1e-5, most_seconds = 10.0;

const char* page_style =
    "text{font-family:'DejaVu Sans','Helvetica Neue',Arial,sans-serif}.page{fill:#fff}"
    ".title{font-size:20px;font-weight:600;fill:#111}.subtitle{font-size:13px;fill:#444}"
    ".caption{font-size:14px;font-weight:600;fill:#111}.count{font-size:12px;fill:#444;text-anchor:end}"
    ".legend{font-size:12px;fill:#222}.mark{stroke-width:1.4;fill-opacity:.6}"
    ".ordinates{stroke:#d55e00;fill:#d55e00}.coefficients{stroke:#009e73;fill:#009e73}"
    ".states{stroke:#0072b2;fill:#0072b2}.mark.hollow{fill:none}.target{stroke:#888;stroke-width:1;"
    "stroke-dasharray:4 4}";

void draw_mark(SvgCanvas& canvas, double x, double y, double size, DesignKind design, bool filled) {
    const std::string looks = fmt::format("mark {}{}", name_of(design), filled ? "" : " hollow");
    if (design == DesignKind::states) {
        canvas.circle(x, y, size, looks);
    } else if (design == DesignKind::coefficients) {
        canvas.rectangle(x - 0.9 * size, y - 0.9 * size, 1.8 * size, 1.8 * size, looks);
    } else {
        const double half = 1.1 * size;
        canvas.path(fmt::format("M{} {}L{} {}L{} {}Z", svg_number(x), svg_number(y - 1.2 * half),
                                svg_number(x + half), svg_number(y + 0.8 * half), svg_number(x - half),
                                svg_number(y + 0.8 * half)),
                    looks);
    }
}

double size_of(int segments) {
    return 2.4 + 1.05 * std::log2(segments / 4.0);
}

bool has_place(const Measurement& row) {
    return row.relative_error && row.seconds_median;
}

struct BackendPanel {
    std::string name;
    double left, top;
};

std::string counts_text(const std::vector<const Measurement*>& rows) {
    const auto count = [&](auto test) { return std::ranges::count_if(rows, test); };
    const auto optimal = count([](const Measurement* row) { return row->verdict == "optimal"; });
    const auto not_run = count([](const Measurement* row) { return row->verdict.empty(); });
    const auto total = static_cast<long>(rows.size());
    return fmt::format("{} rows: {} optimal, {} not proved, {} not run", total, optimal,
                       total - optimal - not_run, not_run);
}

void draw_backend(SvgCanvas& canvas, const BackendPanel& panel, std::span<const Measurement> all) {
    PlotFrame frame;
    frame.horizontal = {least_seconds, most_seconds, panel.left, panel.left + panel_width, true};
    frame.vertical = {least_error, most_error, panel.top + panel_height, panel.top, true};
    frame.horizontal_ticks = decade_ticks(least_seconds, most_seconds, 1);
    frame.vertical_ticks = decade_ticks(least_error, most_error, 3);
    frame.horizontal_title = "seconds (median)";
    frame.vertical_title = "relative error of the objective";
    draw_plot_frame(canvas, frame);
    const double target = frame.vertical.place(1e-7);
    canvas.line(panel.left, target, panel.left + panel_width, target, "target");
    std::vector<const Measurement*> rows;
    for (const Measurement& row : all)
        if (row.combination.backend == panel.name) rows.push_back(&row);
    // Large marks first, so that small ones stay visible.
    std::ranges::stable_sort(rows, std::greater{},
                             [](const Measurement* row) { return row->combination.segments; });
    for (const Measurement* row : rows) {
        if (!has_place(*row)) continue;
        const double x =
            frame.horizontal.place(std::clamp(*row->seconds_median, least_seconds, most_seconds));
        const double y =
            frame.vertical.place(std::clamp(std::abs(*row->relative_error), least_error, most_error));
        draw_mark(canvas, x, y, size_of(row->combination.segments), row->combination.design,
                  row->verdict == "optimal");
    }
    canvas.text(panel.left, panel.top - 10, panel.name, "caption");
    canvas.text(panel.left + panel_width, panel.top - 10, counts_text(rows), "count");
}

void draw_legend(SvgCanvas& canvas, double y) {
    double x = 88;
    for (const DesignKind design : {DesignKind::ordinates, DesignKind::coefficients, DesignKind::states}) {
        draw_mark(canvas, x, y - 4, 5, design, true);
        canvas.text(x + 12, y, name_of(design), "legend");
        x += 118;
    }
    draw_mark(canvas, x, y - 4, 5, DesignKind::states, false);
    canvas.text(x + 12, y, "hollow: not proved optimal", "legend");
    x += 216;
    for (const int segments : {4, 12, 64}) {
        canvas.circle(x, y - 4, size_of(segments), "mark states hollow");
        canvas.text(x + 12, y, fmt::format("n = {}", segments), "legend");
        x += 74;
    }
    canvas.line(x, y - 4, x + 24, y - 4, "target");
    canvas.text(x + 30, y, "gap asked for, 1e−7", "legend");
}

}  // namespace

std::string error_against_time_svg(std::span<const Measurement> rows, const std::string& machine) {
    SvgCanvas canvas(page_width, page_height, std::string(page_style) + std::string(plot_frame_style()),
                     "Error of the objective against run time");
    canvas.rectangle(0, 0, page_width, page_height, "page");
    canvas.text(36, 42, "How exact, how fast: error of the objective against run time", "title");
    canvas.text(
        36, 66,
        "Cubic and quintic splines of 4 to 64 segments, DRD and RR, against the proved optimum. " + machine,
        "subtitle");
    draw_legend(canvas, 98);
    const std::array<BackendPanel, 4> panels = {
        {{"structured", 88, 156}, {"ipopt", 640, 156}, {"nlopt.slsqp", 88, 556}, {"nlopt.cobyla", 640, 556}}};
    for (const BackendPanel& panel : panels) draw_backend(canvas, panel, rows);
    return canvas.finish();
}

}  // namespace camopt::benchmarks
