// SPDX-License-Identifier: MIT
#include "output/chart/sweep/sweep_svg.hpp"

#include "output/chart/placed_texts.hpp"
#include "output/chart/plot_frame.hpp"
#include "output/chart/sweep/sweep_quantities.hpp"
#include "output/view/number_text.hpp"
#include "studies/sweep/sweep_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

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
        weights ? "Triangles: the weight of a peak grows towards its corner. Planes: colour marks the "
                  "Pareto front, grey dots lie off it, diamonds are the laws of the table."
                : "Shaded: proved infeasible. Red with a cross: failed. Dashed: the lower bound for every "
                  "curve. Rings: rows off the Pareto front.";
    canvas.text(margin, 80, words, "subtitle");
}

// The triangle of weights and the planes of two peaks: the trade-off of a weight sweep.
constexpr double bar_room = 40;  // px below a triangle
constexpr double law_number_size = 10.5, diamond = 3.0;

/// Shares of V, A, J in the weights of a row; none where they are all 0.
std::optional<std::array<double, 3>> shares_of(const SweepTable& table, const SweepRow& row) {
    static constexpr std::array<const char*, 3> names = {"objective.velocity", "objective.acceleration",
                                                         "objective.jerk"};
    std::array<double, 3> shares{};
    double sum = 0.0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto key = std::ranges::find(table.columns.keys, names[i]);
        if (key == table.columns.keys.end()) return {};
        shares[i] = row.settings[static_cast<std::size_t>(key - table.columns.keys.begin())];
        sum += shares[i];
    }
    if (!(sum > 0.0)) return {};
    for (double& share : shares) share /= sum;
    return shares;
}

struct Triangle {
    double left, bottom, side;
    [[nodiscard]] std::array<double, 2> place(const std::array<double, 3>& shares) const {
        return {left + side * (shares[1] + 0.5 * shares[2]),
                bottom - side * 0.5 * std::sqrt(3.0) * shares[2]};
    }
};

/// Half the distance of lattice neighbours, if the rows were a lattice of the whole triangle.
double dot_radius(const SweepTable& table, double side) {
    const double divisions = 0.5 * (std::sqrt(8.0 * static_cast<double>(table.rows.size()) + 1.0) - 3.0);
    return std::clamp(0.5 * side / std::max(divisions, 1.0), 1.2, 11.0);
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

void draw_weight_triangle(SvgCanvas& canvas, const PanelFrame& place, const SweepTable& table,
                          const SweepQuantity& quantity) {
    const double side = std::min(place.width, (place.height - bar_room - 36) * 2.0 / std::sqrt(3.0));
    const Triangle triangle{place.left + 0.5 * (place.width - side), place.top + place.height - bar_room - 18,
                            side};
    const ValueRange range = range_of(table.rows, quantity);
    const ColourScale scale{range.lower, range.upper, spans_factors(range)};
    canvas.text(place.left, place.top + 4, quantity.title, "panel-title");
    const auto a = triangle.place({1, 0, 0}), b = triangle.place({0, 1, 0}), c = triangle.place({0, 0, 1});
    canvas.path(fmt::format("M{} {}L{} {}L{} {}Z", svg_number(a[0]), svg_number(a[1]), svg_number(b[0]),
                            svg_number(b[1]), svg_number(c[0]), svg_number(c[1])),
                "frame");
    const double radius = dot_radius(table, side);
    for (const SweepRow& row : table.rows) {
        const auto shares = shares_of(table, row);
        if (!shares) continue;
        const auto at = triangle.place(*shares);
        const std::optional<double> value = quantity.value(row);
        if (row.is_feasible() && value)
            canvas.circle(at[0], at[1], radius, row_class("cell", scale.colour(*value), row));
        else
            canvas.circle(at[0], at[1], radius,
                          row_class(row.verdict == Verdict::failed ? "failed" : "shut", "", row));
    }
    canvas.text(a[0] - 4, a[1] + radius + 14, "V", "corner");
    canvas.text(b[0] + 4, b[1] + radius + 14, "A", "corner");
    canvas.text(c[0] + radius + 10, c[1] + 4, "J", "corner");
    if (!range.empty())
        draw_colour_bar(canvas, scale, triangle.left + 0.2 * side, place.top + place.height - 24, 0.6 * side);
}

namespace {

/// Where the laws do not stretch the picture of the rows too much.
ValueRange plane_range(const SweepPicture& picture, std::size_t peak) {
    const ValueRange rows = range_of(picture.table.rows, peak_quantities()[peak]);
    ValueRange range = rows;
    if (picture.losses != nullptr && !rows.empty()) {
        for (const LawLoss& law : picture.losses->laws)
            range.add(std::clamp(law.peaks[peak], 0.5 * rows.lower, 1.25 * rows.upper));
    }
    return range;
}

void draw_laws(SvgCanvas& canvas, const PlotFrame& frame, const LawLosses& losses, const PlanePeaks& peaks) {
    const auto place_of = [&](const LawLoss& law) -> std::optional<std::array<double, 2>> {
        const double across = law.peaks[peaks.across], up = law.peaks[peaks.up];
        if (!frame.horizontal.holds(across) || !frame.vertical.holds(up)) return {};
        return std::array{frame.horizontal.place(across), frame.vertical.place(up)};
    };
    PlacedTexts numbers(frame.horizontal.begin, frame.vertical.end, frame.horizontal.end,
                        frame.vertical.begin);
    std::string outside;
    for (std::size_t i = 0; i < losses.laws.size(); ++i)
        if (!place_of(losses.laws[i])) outside += fmt::format("{}{}", outside.empty() ? "" : ", ", i + 1);
    if (!outside.empty()) {
        const std::string words = "outside: laws " + outside;
        const std::array place = {TextPlace{frame.horizontal.end - 6 - text_width(words, law_number_size),
                                            frame.vertical.end + 15}};
        numbers.draw(canvas, words, place, "law-number", law_number_size);
    }
    for (const LawLoss& law : losses.laws)
        if (const auto at = place_of(law)) numbers.keep_free((*at)[0], (*at)[1], diamond);
    for (std::size_t i = 0; i < losses.laws.size(); ++i) {
        const auto at = place_of(losses.laws[i]);
        if (!at) continue;
        const auto [x, y] = *at;
        canvas.path(fmt::format("M{0} {1}l4 4l-4 4l-4 -4Z", svg_number(x), svg_number(y - 4)), "law");
        const std::string number = std::to_string(i + 1);
        numbers.draw(canvas, number,
                     places_around(x, y, text_width(number, law_number_size), law_number_size), "law-number",
                     law_number_size);
    }
}

}  // namespace

void draw_plane(SvgCanvas& canvas, const PanelFrame& place, const SweepPicture& picture,
                const PlanePeaks& peaks) {
    const std::array<SweepQuantity, 3> all = peak_quantities();
    const SweepQuantity &across = all[peaks.across], &up = all[peaks.up], &third = all[peaks.colour];
    const ValueRange x = plane_range(picture, peaks.across), y = plane_range(picture, peaks.up);
    if (x.empty() || y.empty()) return;
    PlotFrame frame;
    frame.horizontal = axis_over(x, place.left, place.left + place.width);
    frame.vertical = axis_over(y, place.top + place.height, place.top);
    frame.horizontal_ticks = labelled_ticks(frame.horizontal, 6);
    frame.vertical_ticks = labelled_ticks(frame.vertical, 6);
    frame.horizontal_title = across.title;
    frame.vertical_title = up.title;
    draw_plot_frame(canvas, frame);
    const ValueRange colours = range_of(picture.table.rows, third);
    const ColourScale scale{colours.lower, colours.upper, spans_factors(colours)};
    for (const bool front : {false, true}) {  // the front lies on top
        for (const SweepRow& row : picture.table.rows) {
            if (!row.is_feasible() || row.on_front != front) continue;
            const auto h = across.value(row), v = up.value(row), c = third.value(row);
            if (!h || !v || !c) continue;
            canvas.circle(frame.horizontal.place(*h), frame.vertical.place(*v), front ? 3.6 : 2.2,
                          front ? row_class("dot", scale.colour(*c), row) : row_class("off-front", "", row));
        }
    }
    if (picture.losses != nullptr) draw_laws(canvas, frame, *picture.losses, peaks);
    canvas.text(place.left, place.top - 20, fmt::format("{}–{}", across.symbol, up.symbol), "panel-title");
    canvas.text(place.left + place.width - 166, place.top - 16, "colour: " + third.symbol,
                "bar-number right");
    draw_colour_bar(canvas, scale, place.left + place.width - 150, place.top - 26, 150);
}

}  // namespace camopt
