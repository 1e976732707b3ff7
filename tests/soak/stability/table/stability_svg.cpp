// SPDX-License-Identifier: MIT
#include "core/text/parsing.hpp"
#include "report/chart/svg_canvas.hpp"
#include "tests/soak/stability/table/stability_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace camopt::stability {

namespace {

// Layout, px.
constexpr double page_width = 1120, page_height = 900;
constexpr double least_error = 1e-17, most_error = 1e-2;
constexpr double least_condition = 1.0, most_condition = 1e16;

const char* page_style =
    ".label{font-size:13px;fill:#222;text-anchor:end}.count{font-size:12px;fill:#444}"
    ".legend{font-size:12px;fill:#222}.mark{stroke-width:1.2;fill-opacity:.45}"
    ".structured{stroke:#0072b2;fill:#0072b2}.ipopt{stroke:#d55e00;fill:#d55e00}"
    ".slsqp{stroke:#009e73;fill:#009e73}.wrong{stroke:#c00;fill:#c00;fill-opacity:1}"
    ".ordinates{stroke:#d55e00;fill:none;stroke-width:1.8}"
    ".coefficients{stroke:#009e73;fill:none;stroke-width:1.8}"
    ".states{stroke:#0072b2;fill:none;stroke-width:1.8}.dashed{stroke-dasharray:5 4}"
    ".target{stroke:#888;stroke-width:1;stroke-dasharray:4 4}";

std::string_view looks_of(const StabilityRow& row) {
    if (row.judgement == Judgement::wrong) return "mark wrong";
    if (row.backend == "ipopt") return "mark ipopt";
    return row.backend == "nlopt.slsqp" ? "mark slsqp" : "mark structured";
}

std::vector<std::string> groups_of(std::span<const StabilityRow> rows) {
    std::vector<std::string> groups;
    for (const StabilityRow& row : rows)
        if (groups.empty() || groups.back() != row.group) groups.push_back(row.group);
    return groups;
}

std::string count_text(std::span<const StabilityRow> rows, const std::string& group) {
    const auto count = [&](Judgement judgement) {
        return std::ranges::count_if(
            rows, [&](const StabilityRow& row) { return row.group == group && row.judgement == judgement; });
    };
    return fmt::format("{} ok, {} unsolved, {} wrong", count(Judgement::ok), count(Judgement::unsolved),
                       count(Judgement::wrong));
}

/// A line a group: how far the objective lies from what is known, one mark a row.
void draw_errors(SvgCanvas& canvas, std::span<const StabilityRow> rows) {
    constexpr double left = 150, right = 880, top = 150, step = 36;
    const std::vector<std::string> groups = groups_of(rows);
    const double bottom = top + step * static_cast<double>(groups.size());
    PlotFrame frame;
    frame.horizontal = {least_error, most_error, left, right, true};
    frame.vertical = {0.0, 1.0, bottom, top, false};
    frame.horizontal_ticks = decade_ticks(least_error, most_error, 2);
    frame.horizontal_title = "relative error of the objective (16 digits and better stand at the left edge)";
    draw_plot_frame(canvas, frame);
    const double target = frame.horizontal.place(1e-9);
    canvas.line(target, top, target, bottom, "target");
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const double y = top + step * (static_cast<double>(g) + 0.5);
        canvas.text(left - 10, y + 4, groups[g], "label");
        canvas.text(right + 12, y + 4, count_text(rows, groups[g]), "count");
        int place = 0;
        for (const StabilityRow& row : rows) {
            if (row.group != groups[g] || !row.relative_error || row.judgement == Judgement::unsolved)
                continue;
            const double error = std::clamp(std::abs(*row.relative_error), least_error, most_error);
            // Rows of a group side by side, so that equal ones stay visible.
            const double shift = 24.0 * ((place++ * 7 % 19) / 18.0 - 0.5);
            canvas.circle(frame.horizontal.place(error), y + shift, 3.0, looks_of(row));
        }
    }
}

struct Series {
    int degree;
    std::string_view kind;
};

/// "cubic states n = 64": degree, kind and n of a row of the first group.
bool belongs(const StabilityRow& row, const Series& series, int& segments) {
    const std::string begin =
        fmt::format("{} {} n = ", series.degree == 3 ? "cubic" : "quintic", series.kind);
    if (row.backend != "structured" || !row.name.starts_with(begin)) return false;
    segments = static_cast<int>(integer_in(std::string_view(row.name).substr(begin.size())).value());
    return true;
}

void draw_condition(SvgCanvas& canvas, std::span<const StabilityRow> rows, double left,
                    const std::string& title, std::optional<double> StabilityRow::*figure) {
    constexpr double top = 580, bottom = 830, width = 440;
    PlotFrame frame;
    frame.horizontal = {4.0, 256.0, left, left + width, true};
    frame.vertical = {least_condition, most_condition, bottom, top, true};
    for (const int n : {4, 8, 16, 32, 64, 128, 256})
        frame.horizontal_ticks.push_back({static_cast<double>(n), fmt::format("{}", n)});
    frame.vertical_ticks = decade_ticks(least_condition, most_condition, 4);
    frame.horizontal_title = "segments";
    draw_plot_frame(canvas, frame);
    canvas.text(left, top - 12, title, "caption");
    for (const int degree : {3, 5})
        for (const std::string_view kind : {"ordinates", "coefficients", "states"}) {
            std::string path;
            for (const StabilityRow& row : rows) {
                int segments = 0;
                if (!belongs(row, {degree, kind}, segments) || !(row.*figure)) continue;
                const double height = std::clamp(*(row.*figure), least_condition, most_condition);
                path += fmt::format("{}{} {}", path.empty() ? "M" : "L",
                                    svg_number(frame.horizontal.place(segments)),
                                    svg_number(frame.vertical.place(height)));
            }
            if (!path.empty()) canvas.path(path, fmt::format("{}{}", kind, degree == 5 ? " dashed" : ""));
        }
}

void draw_legends(SvgCanvas& canvas) {
    double x = 150;
    for (const auto& [looks, words] : {std::pair{"mark structured", "structured, or chosen by auto"},
                                       {"mark ipopt", "Ipopt"},
                                       {"mark slsqp", "SLSQP"},
                                       {"mark wrong", "wrong"}}) {
        canvas.circle(x, 116, 4, looks);
        canvas.text(x + 10, 120, words, "legend");
        x += 40 + 8.0 * static_cast<double>(std::string_view(words).size());
    }
    canvas.line(x, 116, x + 24, 116, "target");
    canvas.text(x + 30, 120, "tolerance of a solve, 1e−9", "legend");
    x = 88;
    for (const char* kind : {"ordinates", "coefficients", "states"}) {
        canvas.line(x, 536, x + 28, 536, kind);
        canvas.text(x + 34, 540, kind, "legend");
        x += 140;
    }
    canvas.line(x, 536, x + 28, 536, "states dashed");
    canvas.text(x + 34, 540, "dashed: quintic; solid: cubic", "legend");
}

}  // namespace

std::string stability_svg(std::span<const StabilityRow> rows, const std::string& machine) {
    SvgCanvas canvas(page_width, page_height, page_style, "Numerical stability");
    canvas.rectangle(0, 0, page_width, page_height, "page");
    canvas.text(36, 42, "Numerical stability: extreme scenes, and what comes out", "title");
    canvas.text(36, 66,
                "Every mark is a scene: its objective, recomputed from the delivered motion, against what is "
                "known of it.",
                "subtitle");
    canvas.text(36, 86, machine, "subtitle");
    draw_legends(canvas);
    draw_errors(canvas, rows);
    draw_condition(canvas, rows, 88, "condition number of the map to y''",
                   &StabilityRow::condition_acceleration);
    draw_condition(canvas, rows, 640, "condition number of the map to y'''", &StabilityRow::condition_jerk);
    return canvas.finish();
}

}  // namespace camopt::stability
