// SPDX-License-Identifier: MIT
#include "output/chart/sweep/sweep_svg.hpp"

#include "output/chart/colour_scale.hpp"
#include "output/chart/plot_frame.hpp"
#include "output/chart/sweep/sweep_panels.hpp"
#include "output/words/number_text.hpp"
#include "studies/sweep/sweep_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace camopt {

namespace {

// Layout, px.
constexpr double margin = 40, page_width = 1240, head_height = 104;
constexpr double triangle_width = 270, triangle_height = 300;
constexpr double plane_width = 310, plane_height = 270;
constexpr double panel_width = 500, panel_height = 210, map_height = 300;

const std::array<PlanePeaks, 3> planes = {{{0, 1, 2}, {1, 2, 0}, {0, 2, 1}}};

std::string count_sentence(const SweepTable& table) {
    const auto count = [&](auto test) { return std::ranges::count_if(table.rows, test); };
    const auto optimal = count([](const SweepRow& row) { return row.verdict == Verdict::optimal; });
    const auto feasible = count([](const SweepRow& row) { return row.is_feasible(); });
    const auto failed = count([](const SweepRow& row) { return row.verdict == Verdict::failed; });
    const auto shut = count([](const SweepRow& row) { return row.verdict == Verdict::infeasible; });
    const auto front = count([](const SweepRow& row) { return row.on_front; });
    std::string text = fmt::format("{} rows: {} proved optimal", table.rows.size(), optimal);
    if (feasible > optimal) text += fmt::format(", {} feasible only", feasible - optimal);
    if (shut > 0) text += fmt::format(", {} proved infeasible", shut);
    if (failed > 0) text += fmt::format(", {} failed", failed);
    return text + fmt::format("; {} on the Pareto front", front);
}

double height_of_planes(const SweepPicture& picture) {
    double height = plane_height + 100;
    if (picture.losses != nullptr && !picture.losses->laws.empty())
        height += law_table_height(*picture.losses) + 30;
    return height;
}

void draw_planes(SvgCanvas& canvas, const SweepPicture& picture, double top) {
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const double left = margin + 56 + (plane_width + 94) * static_cast<double>(i);
        draw_plane(canvas, {left, top + 40, plane_width, plane_height}, picture, planes[i]);
    }
    if (picture.losses != nullptr && !picture.losses->laws.empty())
        draw_law_table(canvas, margin, top + plane_height + 116, *picture.losses);
}

void draw_triangles(SvgCanvas& canvas, const SweepPicture& picture, double top) {
    std::vector<SweepQuantity> quantities = {objective_quantity()};
    for (SweepQuantity& peak : peak_quantities()) quantities.push_back(std::move(peak));
    for (std::size_t i = 0; i < quantities.size(); ++i) {
        const double left = margin + (triangle_width + 27) * static_cast<double>(i);
        draw_weight_triangle(canvas, {left, top, triangle_width, triangle_height}, picture.table,
                             quantities[i]);
    }
}

double panel_rows(std::size_t panels) {
    return static_cast<double>((panels + 1) / 2);
}

void draw_panels(SvgCanvas& canvas, const SweepPicture& picture, double top, int key) {
    const std::vector<SweepQuantity> quantities = drawn_quantities(picture.table);
    const bool map = is_map(picture.table);
    const double height = map ? map_height : panel_height;
    for (std::size_t i = 0; i < quantities.size(); ++i) {
        const PanelFrame place{margin + 60 + (panel_width + 110) * static_cast<double>(i % 2),
                               top + 30 + (height + 80) * static_cast<double>(i / 2), panel_width, height};
        if (map)
            draw_map(canvas, place, picture.table, quantities[i]);
        else
            draw_lines(canvas, place, picture.table, quantities[i], key);
    }
}

void draw_head(SvgCanvas& canvas, const SweepPicture& picture, const std::string& title) {
    canvas.text(margin, 38, title, "title");
    canvas.text(margin, 61, count_sentence(picture.table), "subtitle");
    const bool weights = is_weight_sweep(picture.table);
    const std::string words =
        weights ? "Triangles: the nearer to a corner, the more that peak weighs. Planes: colour marks the "
                  "Pareto front, grey dots lie off it, diamonds are the laws of the table."
                : "Shaded: proved infeasible. Red with a cross: failed. Dashed: the limit that no curve can "
                  "pass. Rings: rows off the Pareto front.";
    canvas.text(margin, 80, words, "subtitle");
}

}  // namespace

std::string sweep_panel_style() {
    return ".panel-title{font-size:14px;font-weight:600;fill:#222}"
           ".corner{font-size:13px;font-weight:600;fill:#333;text-anchor:middle}.law-bar{fill:#8c8c8c}"
           ".value.tight{font-size:9px}.law{fill:#fff;stroke:#111;stroke-width:1.3}.law-number{font-size:10."
           "5px;fill:#111}"
           ".law-number.right{text-anchor:end}.dot{stroke:#222;stroke-width:.4}.off-front{fill:#c4c4c4}"
           ".shut{fill:#e4e4e4}.failed{fill:#f4c7c3}.cross{fill:none;stroke:#b3261e;stroke-width:2}"
           ".row-line{fill:none;stroke:#0072b2;stroke-width:1.8}.row-dot{fill:#0072b2;stroke:#0072b2}"
           ".row-dot.off{fill:#fff}"
           ".limit-line{fill:none;stroke:#555;stroke-width:1.3;stroke-dasharray:5 4}" +
           colour_scale_style();
}

std::string row_class(const char* kind, const std::string& colour, const SweepRow& row) {
    return fmt::format("{} {}{}r{}", kind, colour, colour.empty() ? "" : " ", row.number);
}

bool is_weight_sweep(const SweepTable& table) {
    const std::vector<std::string>& keys = table.columns.keys;
    const auto has = [&](const char* key) { return std::ranges::find(keys, key) != keys.end(); };
    return std::ranges::all_of(keys, [](const std::string& key) { return is_weight_key(key); }) &&
           has("objective.velocity") && has("objective.acceleration") && has("objective.jerk");
}

std::string sweep_svg(const SweepPicture& picture) {
    const bool weights = is_weight_sweep(picture.table);
    const bool lines = picture.table.columns.keys.size() == 1 || is_map(picture.table);
    const bool map = is_map(picture.table);
    double height = head_height;
    if (weights) height += triangle_height + 30;
    if (weights || !lines) height += height_of_planes(picture);
    if (!weights)
        height +=
            panel_rows(drawn_quantities(picture.table).size()) * ((map ? map_height : panel_height) + 80) +
            30;
    const std::string title = picture.scene.title.empty() ? "Sweep" : picture.scene.title;
    SvgCanvas canvas(page_width, height, sweep_panel_style(), title);
    canvas.rectangle(0, 0, page_width, height, "page");
    draw_head(canvas, picture, title);
    double top = head_height;
    if (weights) {
        draw_triangles(canvas, picture, top);
        top += triangle_height + 30;
    }
    if (weights || !lines) {
        draw_planes(canvas, picture, top);
        top += height_of_planes(picture);
    }
    if (!weights) draw_panels(canvas, picture, top, lines ? 0 : -1);
    return canvas.finish();
}

}  // namespace camopt
