// SPDX-License-Identifier: MIT
// A quantity of a sweep over one key, or over two.
#include "output/chart/placed_texts.hpp"
#include "output/chart/sweep/sweep_quantities.hpp"
#include "output/view/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

double key_value(const SweepRow& row, int key) {
    return key < 0 ? static_cast<double>(row.number) : row.settings[static_cast<std::size_t>(key)];
}

std::vector<const SweepRow*> sorted_rows(const SweepTable& table, int key) {
    std::vector<const SweepRow*> rows;
    for (const SweepRow& row : table.rows) rows.push_back(&row);
    std::ranges::stable_sort(rows, {}, [&](const SweepRow* row) { return key_value(*row, key); });
    return rows;
}

/// Ascending, positive, and about evenly spaced only in their logarithms.
bool wants_logarithm(const std::vector<const SweepRow*>& rows, int key) {
    if (rows.size() < 3) return false;
    const double first = key_value(*rows.front(), key), last = key_value(*rows.back(), key);
    const double middle = key_value(*rows[rows.size() / 2], key);
    return first > 0.0 && last > 20.0 * first && middle < 0.2 * last;
}

/// Halfway to the neighbour, for the width a row stands for.
double cell_edge(const std::vector<const SweepRow*>& rows, std::size_t i, int side, const PlotAxis& axis,
                 int key) {
    const double here = axis.place(key_value(*rows[i], key));
    if ((side < 0 && i == 0) || (side > 0 && i + 1 == rows.size())) return here + 3.0 * side;
    return 0.5 * (here + axis.place(key_value(*rows[i + static_cast<std::size_t>(side)], key)));
}

void shade_infeasible(SvgCanvas& canvas, const PlotFrame& frame, const std::vector<const SweepRow*>& rows,
                      int key) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i]->is_feasible()) continue;
        const double from = std::max(cell_edge(rows, i, -1, frame.horizontal, key), frame.horizontal.begin);
        const double to = std::min(cell_edge(rows, i, 1, frame.horizontal, key), frame.horizontal.end);
        const bool failed = rows[i]->verdict == Verdict::failed;
        canvas.rectangle(from, frame.vertical.end, to - from, frame.vertical.begin - frame.vertical.end,
                         row_class(failed ? "failed" : "shut", "", *rows[i]));
        if (failed) {
            const double x = 0.5 * (from + to), y = frame.vertical.begin - 12;
            canvas.path(fmt::format("M{} {}l8 8m0 -8l-8 8", svg_number(x - 4), svg_number(y - 4)), "cross");
        }
    }
}

/// A line through neighbouring values, broken where one is missing.
template <typename Value>
void draw_line(SvgCanvas& canvas, const PlotFrame& frame, const std::vector<const SweepRow*>& rows, int key,
               const char* look, Value value) {
    std::string path;
    bool open = false;
    for (const SweepRow* row : rows) {
        const std::optional<double> here = value(*row);
        if (!here || !frame.vertical.holds(*here)) {
            open = false;
            continue;
        }
        path +=
            fmt::format("{}{} {}", open ? "L" : "M", svg_number(frame.horizontal.place(key_value(*row, key))),
                        svg_number(frame.vertical.place(*here)));
        open = true;
    }
    if (!path.empty()) canvas.path(path, look);
}

// Where the classical laws lie above the trade-off, as lines of the picture.
constexpr double line_height = 21, head_height = 54;
constexpr double bar_left = 582, bar_width = 120, bar_number = 60;

/// "−29.6 %": what the best motion saves of the law's peak.
std::string saving_words(const LawLoss& law, std::size_t peak) {
    if (!law.least[peak]) return "–";
    return change_text(*law.least[peak], law.peaks[peak]);
}

std::string percent_words(const std::optional<double>& percent) {
    return percent ? change_text(100.0 + *percent, 100.0) : "–";
}

/// Before the column of V; long names are set smaller.
void draw_name(SvgCanvas& canvas, double left, double y, const LawLoss& law) {
    constexpr double room = 232.0, size = 12.0;
    const std::string name = law.title + (law.feasible ? "" : " *");
    canvas.text(left, y, name,
                fmt::format("value{}{}", law.feasible ? "" : " faint",
                            text_width(name, size) > room ? " tight" : ""));
}

void draw_heads(SvgCanvas& canvas, double left, double top, bool all_feasible) {
    canvas.text(left, top, "Laws above the trade-off", "panel-title");
    const double y = top + 36;
    canvas.text(left + 26, y, all_feasible ? "law" : "law (* violates a limit)", "head left");
    for (const auto& [x, words] : {std::pair{304.0, "V"}, {364.0, "A"}, {430.0, "J"}})
        canvas.text(left + x, y, words, "head");
    canvas.text(left + 552, y - 15, "loss at the", "head");
    canvas.text(left + 552, y, "scene’s weights", "head");
    canvas.text(left + bar_left, y - 15, "least loss", "head left");
    canvas.text(left + bar_left, y, "over all weights", "head left");
    canvas.text(left + 895, y - 15, "at the weights", "head");
    canvas.text(left + 895, y, "V / A / J", "head");
    canvas.text(left + 1130, y - 15, "one peak alone can decrease by", "head");
    for (const auto& [x, words] : {std::pair{990.0, "V"}, {1060.0, "A"}, {1130.0, "J"}})
        canvas.text(left + x, y, words, "head");
}

void draw_least_loss(SvgCanvas& canvas, double left, double y, const LawLoss& law, double longest) {
    if (!law.closest) {
        canvas.text(left + bar_left + bar_number, y, "–", "value right");
        return;
    }
    const double loss = law.closest->loss_percent;
    canvas.text(left + bar_left + bar_number, y, percent_words(loss), "value right");
    const double width = longest > 0.0 ? bar_width * std::max(loss, 0.0) / longest : 0.0;
    canvas.rectangle(left + bar_left + bar_number + 8, y - 10, width, 12, "law-bar");
    const PeakTriple& w = law.closest->weights;
    canvas.text(left + 895, y, fmt::format("{:.2f} / {:.2f} / {:.2f}", w[0], w[1], w[2]), "value right");
}

std::vector<double> values_of(const SweepTable& table, int key) {
    std::vector<double> values;
    for (const SweepRow& row : table.rows) values.push_back(key_value(row, key));
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

}  // namespace

void draw_lines(SvgCanvas& canvas, const PanelFrame& place, const SweepTable& table,
                const SweepQuantity& quantity, int key) {
    canvas.text(place.left, place.top - 9, quantity.title, "panel-title");
    const std::vector<const SweepRow*> rows = sorted_rows(table, key);
    ValueRange values = range_of(table.rows, quantity);
    const bool limit = quantity.symbol == "f";
    if (limit) {
        for (const SweepRow& row : table.rows)
            if (row.is_feasible() && row.any_curve_limit) values.add(*row.any_curve_limit);
    }
    if (rows.empty()) return;
    if (values.empty()) values.add(0.0);
    values = values.padded(0.06);
    ValueRange across;
    for (const SweepRow* row : rows) across.add(key_value(*row, key));
    const bool logarithmic = wants_logarithm(rows, key);
    if (!logarithmic) across = across.padded(0.02);
    PlotFrame frame;
    frame.horizontal = {across.lower, across.upper, place.left, place.left + place.width, logarithmic};
    frame.vertical = {values.lower, values.upper, place.top + place.height, place.top, false};
    frame.horizontal_ticks =
        logarithmic ? decade_ticks(across.lower, across.upper, 1) : labelled_ticks(frame.horizontal, 6);
    frame.vertical_ticks = labelled_ticks(frame.vertical, 5);
    frame.horizontal_title = key < 0 ? "row" : table.columns.keys[static_cast<std::size_t>(key)];
    shade_infeasible(canvas, frame, rows, key);
    draw_plot_frame(canvas, frame);
    if (limit)
        draw_line(canvas, frame, rows, key, "limit-line",
                  [](const SweepRow& row) { return row.is_feasible() ? row.any_curve_limit : std::nullopt; });
    draw_line(canvas, frame, rows, key, "row-line",
              [&](const SweepRow& row) { return row.is_feasible() ? quantity.value(row) : std::nullopt; });
    for (const SweepRow* row : rows) {
        const std::optional<double> value = row->is_feasible() ? quantity.value(*row) : std::nullopt;
        if (!value) continue;
        canvas.circle(frame.horizontal.place(key_value(*row, key)), frame.vertical.place(*value), 3.0,
                      row_class(row->on_front ? "row-dot" : "row-dot off", "", *row));
    }
}

bool is_map(const SweepTable& table) {
    if (table.columns.keys.size() != 2) return false;
    const std::size_t x = values_of(table, 0).size(), y = values_of(table, 1).size();
    return x > 1 && y > 1 && x * y == table.rows.size();
}

void draw_map(SvgCanvas& canvas, const PanelFrame& place, const SweepTable& table,
              const SweepQuantity& quantity) {
    const std::vector<double> xs = values_of(table, 1), ys = values_of(table, 0);
    const double width = place.width / static_cast<double>(xs.size());
    const double height = place.height / static_cast<double>(ys.size());
    const ValueRange range = range_of(table.rows, quantity);
    const ColourScale scale{range.lower, range.upper, spans_factors(range)};
    canvas.text(place.left, place.top - 9, quantity.title, "panel-title");
    for (const SweepRow& row : table.rows) {
        const auto column = std::ranges::lower_bound(xs, row.settings[1]) - xs.begin();
        const auto line = std::ranges::lower_bound(ys, row.settings[0]) - ys.begin();
        const double x = place.left + width * static_cast<double>(column);
        const double y = place.top + place.height - height * static_cast<double>(line + 1);
        const std::optional<double> value = row.is_feasible() ? quantity.value(row) : std::nullopt;
        canvas.rectangle(x, y, width, height,
                         value ? row_class("cell", scale.colour(*value), row)
                               : row_class(row.verdict == Verdict::failed ? "failed" : "shut", "", row));
        if (row.verdict == Verdict::failed)
            canvas.path(fmt::format("M{} {}l8 8m0 -8l-8 8", svg_number(x + 0.5 * width - 4),
                                    svg_number(y + 0.5 * height - 4)),
                        "cross");
    }
    const auto label = [](std::size_t i, std::size_t count) {
        return count <= 8 || i % (count / 6 + 1) == 0;
    };
    for (std::size_t i = 0; i < xs.size(); ++i)
        if (label(i, xs.size()))
            canvas.text(place.left + width * (static_cast<double>(i) + 0.5), place.top + place.height + 16,
                        short_text(xs[i], 4), "tick middle");
    for (std::size_t i = 0; i < ys.size(); ++i)
        if (label(i, ys.size()))
            canvas.text(place.left - 7,
                        place.top + place.height - height * (static_cast<double>(i) + 0.5) + 4,
                        short_text(ys[i], 4), "tick right");
    canvas.rectangle(place.left, place.top, place.width, place.height, "frame");
    canvas.text(place.left + 0.5 * place.width, place.top + place.height + 36, table.columns.keys[1],
                "axis-title");
    canvas.text(place.left - 52, place.top + 0.5 * place.height, table.columns.keys[0], "axis-title", 90.0);
    if (!range.empty()) draw_colour_bar(canvas, scale, place.left + place.width - 150, place.top - 28, 150);
}

double law_table_height(const LawLosses& losses) {
    return head_height + line_height * static_cast<double>(losses.laws.size());
}

double draw_law_table(SvgCanvas& canvas, double left, double top, const LawLosses& losses) {
    draw_heads(canvas, left, top, std::ranges::all_of(losses.laws, &LawLoss::feasible));
    double longest = 0.0;
    for (const LawLoss& law : losses.laws)
        if (law.closest) longest = std::max(longest, law.closest->loss_percent);
    double y = top + head_height + 6;
    for (std::size_t i = 0; i < losses.laws.size(); ++i) {
        const LawLoss& law = losses.laws[i];
        canvas.text(left, y, std::to_string(i + 1), "value");
        draw_name(canvas, left + 26, y, law);
        canvas.text(left + 304, y, fixed_text(law.peaks[0], 3), "value right");
        canvas.text(left + 364, y, fixed_text(law.peaks[1], 3), "value right");
        canvas.text(left + 430, y, fixed_text(law.peaks[2], 2), "value right");
        canvas.text(left + 552, y, percent_words(law.loss_percent), "value right");
        draw_least_loss(canvas, left, y, law, longest);
        for (std::size_t peak = 0; peak < 3; ++peak)
            canvas.text(left + 990 + 70.0 * static_cast<double>(peak), y, saving_words(law, peak),
                        "value right");
        y += line_height;
    }
    return law_table_height(losses);
}

}  // namespace camopt
