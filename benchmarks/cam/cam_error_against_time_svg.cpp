// SPDX-License-Identifier: MIT
#include "benchmarks/cam/cam_error_against_time_svg.hpp"

#include "report/chart/svg_canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace camopt::benchmarks {

namespace {

// Layout, px.
constexpr double page_width = 1120, page_height = 860, panel_width = 268, panel_height = 290;
constexpr double first_left = 88, column = 364, first_top = 126, row_height = 386;
constexpr int columns = 3;
// Below this the error is rounding of the objective itself; such marks stand on the lowest line.
constexpr double least_error = 1e-15, most_error = 1.0;
constexpr double least_seconds = 1e-4, most_seconds = 100.0;

const char* page_style =
    ".count{font-size:12px;fill:#444}.legend{font-size:12px;fill:#222}"
    ".mark{stroke-width:1.4;fill-opacity:.6}.s0{stroke:#7fbde6;fill:#7fbde6}"
    ".s1{stroke:#0072b2;fill:#0072b2}.s2{stroke:#003a5c;fill:#003a5c}"
    ".s3{stroke:#d55e00;fill:#d55e00}.s4{stroke:#e69f00;fill:#e69f00}"
    ".s5{stroke:#009e73;fill:#009e73}.s6{stroke:#cc79a7;fill:#cc79a7}"
    ".s7{stroke:#7a5cc4;fill:#7a5cc4}.s8{stroke:#333;fill:#333}.s9{stroke:#c0a000;fill:#c0a000}"
    ".mark.hollow{fill:none}.target{stroke:#888;stroke-width:1;stroke-dasharray:4 4}";

struct Mark {
    double x, y, size;
    int scene;
    bool filled;
};

std::string polygon(const Mark& mark, std::span<const std::array<double, 2>> corners) {
    std::string path;
    for (const auto& [dx, dy] : corners)
        path += fmt::format("{}{} {}", path.empty() ? 'M' : 'L', svg_number(mark.x + dx * mark.size),
                            svg_number(mark.y + dy * mark.size));
    return path + "Z";
}

constexpr std::array<std::array<double, 2>, 4> square = {
    {{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}}};
constexpr std::array<std::array<double, 2>, 4> diamond = {{{0, -1.25}, {1.25, 0}, {0, 1.25}, {-1.25, 0}}};
constexpr std::array<std::array<double, 2>, 3> triangle = {{{0, -1.3}, {1.1, 0.9}, {-1.1, 0.9}}};

void draw_mark(SvgCanvas& canvas, const Mark& mark) {
    const std::string looks = fmt::format("mark s{}{}", mark.scene, mark.filled ? "" : " hollow");
    if (mark.scene < 3) {  // the three radii of one scene share a shape
        canvas.circle(mark.x, mark.y, mark.size, looks);
    } else if (mark.scene % 3 == 0) {
        canvas.path(polygon(mark, square), looks);
    } else {
        canvas.path(mark.scene % 3 == 1 ? polygon(mark, diamond) : polygon(mark, triangle), looks);
    }
}

double size_of(int segments) {
    return 3.0 + 1.3 * std::log2(segments / 12.0);
}

bool has_place(const CamMeasurement& row) {
    return row.relative_error && row.seconds_median;
}

/// Distinct values in the order of their first appearance.
template <class Name>
std::vector<std::string> names(std::span<const CamMeasurement> rows, Name name) {
    std::vector<std::string> found;
    for (const CamMeasurement& row : rows)
        if (std::ranges::find(found, name(row)) == found.end()) found.push_back(name(row));
    return found;
}

std::string counts_text(const std::vector<const CamMeasurement*>& rows) {
    const auto count = [&](auto test) { return std::ranges::count_if(rows, test); };
    const auto optimal = count([](const auto* row) { return row->verdict == "optimal"; });
    const auto not_run = count([](const auto* row) { return row->verdict.empty(); });
    const auto no_motion = count([](const auto* row) { return !row->verdict.empty() && !row->objective; });
    std::string text = fmt::format("{} rows: {} optimal", rows.size(), optimal);
    const auto add = [&](long number, const char* what) {
        if (number > 0) text += fmt::format(", {} {}", number, what);
    };
    add(static_cast<long>(rows.size()) - optimal - not_run - no_motion, "not proved");
    add(no_motion, "no motion");
    add(not_run, "not run");
    return text;
}

struct Panel {
    std::string name;
    double left, top;
};

PlotFrame frame_of(const Panel& panel) {
    PlotFrame frame;
    frame.horizontal = {least_seconds, most_seconds, panel.left, panel.left + panel_width, true};
    frame.vertical = {least_error, most_error, panel.top + panel_height, panel.top, true};
    frame.horizontal_ticks = decade_ticks(least_seconds, most_seconds, 1);
    frame.vertical_ticks = decade_ticks(least_error, most_error, 3);
    frame.horizontal_title = "seconds (median)";
    if (panel.left == first_left) frame.vertical_title = "relative error of the objective";
    return frame;
}

void draw_panel(SvgCanvas& canvas, const Panel& panel, std::span<const CamMeasurement> all) {
    const PlotFrame frame = frame_of(panel);
    draw_plot_frame(canvas, frame);
    const double target = frame.vertical.place(1e-7);
    canvas.line(panel.left, target, panel.left + panel_width, target, "target");
    const std::vector<std::string> scenes = names(all, [](const auto& row) { return row.scene; });
    std::vector<const CamMeasurement*> rows;
    for (const CamMeasurement& row : all)
        if (row.backend.name() == panel.name) rows.push_back(&row);
    // Large marks first, so that small ones stay visible.
    std::ranges::stable_sort(rows, std::greater{}, [](const auto* row) { return row->segments; });
    for (const CamMeasurement* row : rows) {
        if (!has_place(*row)) continue;
        const auto scene = std::ranges::find(scenes, row->scene) - scenes.begin();
        draw_mark(canvas,
                  {frame.horizontal.place(std::clamp(*row->seconds_median, least_seconds, most_seconds)),
                   frame.vertical.place(std::clamp(std::abs(*row->relative_error), least_error, most_error)),
                   size_of(row->segments), static_cast<int>(scene), row->verdict == "optimal"});
    }
    canvas.text(panel.left, panel.top - 26, panel.name, "caption");
    canvas.text(panel.left, panel.top - 9, counts_text(rows), "count");
}

void draw_legend(SvgCanvas& canvas, double left, double top, std::span<const CamMeasurement> rows) {
    double y = top;
    int scene = 0;
    for (const std::string& name : names(rows, [](const auto& row) { return row.scene; })) {
        draw_mark(canvas, {left + 8, y - 4, 5, scene++, true});
        canvas.text(left + 24, y, name, "legend");
        y += 21;
    }
    draw_mark(canvas, {left + 8, y - 4, 5, 1, false});
    canvas.text(left + 24, y, "hollow: not proved optimal", "legend");
    y += 21;
    double x = left + 8;
    for (const int segments : {12, 24, 48}) {
        draw_mark(canvas, {x, y - 4, size_of(segments), 1, false});
        canvas.text(x + 14, y, fmt::format("n = {}", segments), "legend");
        x += 76;
    }
    y += 21;
    canvas.line(left - 2, y - 4, left + 18, y - 4, "target");
    canvas.text(left + 24, y, "gap asked for, 1e−7", "legend");
}

}  // namespace

std::string cam_error_against_time_svg(std::span<const CamMeasurement> rows, const std::string& machine) {
    SvgCanvas canvas(page_width, page_height, page_style,
                     "Scenes with a cam: error of the objective against run time");
    canvas.rectangle(0, 0, page_width, page_height, "page");
    canvas.text(36, 42, "Scenes with a cam: error of the objective against run time", "title");
    canvas.text(36, 66,
                "Splines of 12 to 48 segments, against the proved optimum or the best known. " + machine,
                "subtitle");
    int place = 0;
    const auto left = [&] { return first_left + column * (place % columns); };
    const auto top = [&] { return first_top + row_height * (place / columns); };
    for (const std::string& backend : names(rows, [](const auto& row) { return row.backend.name(); })) {
        draw_panel(canvas, {backend, left(), top()}, rows);
        ++place;
    }
    draw_legend(canvas, left(), top() + 20, rows);
    return canvas.finish();
}

}  // namespace camopt::benchmarks
