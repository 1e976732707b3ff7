// SPDX-License-Identifier: MIT
// The triangle of weights and the planes of two peaks: the trade-off of a weight sweep.
#include "output/chart/colour_scale.hpp"
#include "output/chart/placed_texts.hpp"
#include "output/chart/sweep/sweep_panels.hpp"
#include "output/words/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt {

namespace {

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
