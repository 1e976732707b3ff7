// SPDX-License-Identifier: MIT
#include "report/chart/chart.hpp"

#include "report/view/number_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Layout, px.
constexpr double margin = 40, least_page_width = 640, title_line = 26, text_line = 18, legend_line = 20;
constexpr double column_gap = 26, row_gap = 24, head_line = 15, cell_gap = 15;
constexpr double title_font = 20, line_font = 13, caption_font = 14, value_font = 12;
constexpr double least_drawn = 0.3;  // a step of a line shorter than this is not drawn
constexpr double sample_width = 28, bar_height = 14, colour_bar_width = 150, colour_bar_height = 8;
constexpr double least_equal_height = 160;

// Viridis (S. van der Walt, N. Smith, CC0) at sixteen even places.
constexpr int colour_steps = 16;
constexpr std::array<const char*, colour_steps> colours = {
    "#440154", "#481a6c", "#472f7d", "#414487", "#39568c", "#31688e", "#2a788e", "#23888e",
    "#1f988b", "#22a884", "#35b779", "#54c568", "#7ad151", "#a5db36", "#d2e21b", "#fde725"};

// M. Okabe, K. Ito, Color Universal Design (2008), and two greys.
constexpr std::array<const char*, 8> palette = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                "#e69f00", "#56b4e9", "#333333", "#8c8c8c"};

constexpr std::string_view hatch =
    "<defs><pattern id=\"hatch\" width=\"4.3\" height=\"4.3\" patternUnits=\"userSpaceOnUse\" "
    "patternTransform=\"rotate(45)\"><rect width=\"4.3\" height=\"4.3\" fill=\"#f6f6f6\"/>"
    "<line y2=\"4.3\" stroke=\"#b5b5b5\" stroke-width=\"2.4\"/></pattern></defs>\n";

/// The one style sheet: #0072b2 is the result, grey what it is compared with, green bounds, red limits.
std::string chart_style() {
    std::string style =
        "path{fill:none}"  // of a line with more than two points; marks name their fill
        ".optimum{fill:none;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:round}"
        ".row-line{fill:none;stroke:#0072b2;stroke-width:1.6}"
        ".reference{fill:none;stroke:#6b6b6b;stroke-width:1.5;stroke-dasharray:6 4}"
        ".measured{fill:none;stroke:#009e73;stroke-width:1.5;stroke-dasharray:2 2.5}"
        ".measured-point{fill:#009e73}"
        ".limit-line{fill:none;stroke:#009e73;stroke-width:1.8;stroke-dasharray:6 4}"
        ".limit{stroke:#c81e1e;stroke-width:1.6;stroke-dasharray:1.6 4;stroke-linecap:round}"
        ".segment{stroke:#555;stroke-width:1;stroke-dasharray:8 3}"
        ".breakpoint{stroke:#9a9a9a;stroke-width:1}.set-point{fill:#fff;stroke:#d55e00;stroke-width:1.8}"
        ".set-region{stroke:#d55e00;stroke-width:5;stroke-opacity:.35}"
        ".limit-label,.segment-label,.peak-label{paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-"
        "linejoin:round}"
        ".limit-label{font-size:11.5px;fill:#c81e1e}.segment-label{font-size:11.5px;fill:#444}"
        ".peak{fill:#0072b2;stroke:#fff;stroke-width:1.5}.peak-label{font-weight:600;fill:#005a8c}"
        ".row-dot{fill:#0072b2;stroke:#0072b2}.row-dot.off{fill:#fff}"
        ".law{fill:#fff;stroke:#111;stroke-width:1.3}.law-number{font-size:10.5px;fill:#111}"
        ".dot{stroke:#222;stroke-width:.4}.off-front{fill:#c4c4c4}.shut{fill:#e4e4e4}.failed{fill:#f4c7c3}"
        ".cross{fill:none;stroke:#b3261e;stroke-width:2}.optimum-bar{fill:#0072b2}.law-bar{fill:#8c8c8c}"
        ".broken-bar{fill:url(#hatch);stroke:#b5b5b5}.cut{stroke:#fff;stroke-width:3}"
        ".optimum-line{stroke:#0072b2;stroke-width:1.4;stroke-dasharray:5 3}"
        ".best{font-weight:600;fill:#0072b2}.remark{font-size:11px;fill:#555}.note{fill:#555}"
        ".warning{fill:#c00000}.corner{font-size:13px;font-weight:600;fill:#333}";
    for (std::size_t i = 0; i < palette.size(); ++i)
        style += fmt::format(
            ".l{0}{{fill:none;stroke:{1};stroke-width:1.8;stroke-linejoin:round}}.p{0}{{fill:{1}}}", i,
            palette[i]);
    for (std::size_t i = 0; i < colours.size(); ++i) style += fmt::format(".c{}{{fill:{}}}", i, colours[i]);
    return style;
}

/// Lines no wider than the room: broken at the last " · " that fits, else at the last blank.
std::vector<std::string> wrapped(std::string words, double room, double font, bool bold = false) {
    std::vector<std::string> lines;
    const auto last = [&](std::string_view mark) {
        std::size_t found = std::string::npos;
        for (std::size_t at = words.find(mark);
             at != std::string::npos && text_width(words.substr(0, at), font, bold) <= room;
             at = words.find(mark, at + 1))
            if (at > 0) found = at;
        return found;
    };
    while (text_width(words, font, bold) > room) {
        std::string_view mark = " · ";
        if (last(mark) == std::string::npos) mark = " ";
        const std::size_t end = last(mark);
        if (end == std::string::npos) break;
        lines.push_back(words.substr(0, end));
        words.erase(0, end + mark.size());
    }
    lines.push_back(std::move(words));
    return lines;
}

void draw_mark(SvgCanvas& canvas, Look look, const TextPlace& at, double size, const std::string& css) {
    switch (look) {
        case Look::line:
            return canvas.line(at.x - size, at.y, at.x + size, at.y, css);
        case Look::dot:
        case Look::disc:
            return canvas.circle(at.x, at.y, size, css);
        case Look::square:
            return canvas.rectangle(at.x - size, at.y - size, 2.0 * size, 2.0 * size, css);
        case Look::diamond:
            return canvas.path(fmt::format("M{0} {1}l{2} {2}l-{2} {2}l-{2} -{2}Z", svg_number(at.x),
                                           svg_number(at.y - size), svg_number(size)),
                               css);
        case Look::rule:
        case Look::tick:
            return canvas.line(at.x, at.y, at.x, at.y - 2.0 * size, css);
        case Look::bar:
            return canvas.rectangle(at.x - size, at.y - 0.5 * bar_height, 2.0 * size, bar_height, css);
        case Look::cell:
        case Look::band:
        case Look::label:
            return;
    }
}

/// A plot on its way to the canvas.
struct Plot {
    SvgCanvas& canvas;
    const ChartPanel& panel;
    PlotFrame frame;
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
    PlacedTexts labels;

    [[nodiscard]] double x(double value) const { return frame.horizontal.place(value); }
    [[nodiscard]] double y(double value) const { return frame.vertical.place(value); }
    [[nodiscard]] bool holds(const ChartPoint& point) const {
        return frame.horizontal.holds(point.x) && frame.vertical.holds(point.y);  // false for NaN
    }
};

void draw_line(Plot& plot, const ChartSeries& series) {
    const ChartPoint &first = series.points.front(), &last = series.points.back();
    if (series.points.size() == 2 && plot.holds(first) && plot.holds(last)) {
        plot.labels.avoid({plot.x(first.x), plot.y(first.y)}, {plot.x(last.x), plot.y(last.y)});
        return plot.canvas.line(plot.x(first.x), plot.y(first.y), plot.x(last.x), plot.y(last.y), series.css);
    }
    std::string data;
    bool pen_down = false;
    double last_x = 0.0, last_y = 0.0;
    for (const ChartPoint& point : series.points) {
        const bool inside = plot.holds(point);
        if (inside) {
            const double x = plot.x(point.x), y = plot.y(point.y);
            const bool far = std::abs(x - last_x) >= least_drawn || std::abs(y - last_y) >= least_drawn;
            if (!pen_down || far || &point == &last) {
                data += (pen_down ? "L" : "M") + svg_number(x) + " " + svg_number(y);
                if (pen_down) plot.labels.avoid({last_x, last_y}, {x, y});
                last_x = x;
                last_y = y;
            }
        }
        pen_down = inside;
    }
    if (!data.empty()) plot.canvas.path(data, series.css);
}

void draw_box(const Plot& plot, const TextPlace& from, const TextPlace& to, const std::string& css) {
    plot.canvas.rectangle(from.x, from.y, to.x - from.x, to.y - from.y, css);
    if (!css.starts_with("failed")) return;
    plot.canvas.path(fmt::format("M{} {}l8 8m0 -8l-8 8", svg_number(0.5 * (from.x + to.x) - 4),
                                 svg_number(0.5 * (from.y + to.y) - 4)),
                     "cross");
}

void draw_point(Plot& plot, const ChartSeries& series, const ChartPoint& point) {
    const std::string css =
        series.css.empty() || point.css.empty() ? series.css + point.css : series.css + " " + point.css;
    const double y = plot.y(point.y), x = plot.x(std::min(point.x, plot.frame.horizontal.upper));
    const double across = plot.x(point.x + series.size) - x, up = y - plot.y(point.y + series.size);
    if (series.look == Look::bar) {
        draw_box(plot, {plot.left, y - 0.5 * bar_height}, {std::max(x, plot.left), y + 0.5 * bar_height},
                 css);
        if (point.x > plot.frame.horizontal.upper)
            plot.canvas.line(x - 18, y + 0.5 * bar_height + 1, x - 10, y - 0.5 * bar_height - 1, "cut");
    } else if (series.look == Look::rule) {
        plot.canvas.line(x, plot.top, x, plot.bottom, css);
    } else if (series.look == Look::cell) {
        draw_box(plot, {x - across, y - up}, {x + across, y + up}, css);
    } else if (series.look == Look::disc) {
        draw_mark(plot.canvas, Look::dot, {x, y}, std::clamp(across, 1.2, 11.0), css);
    } else if (series.look != Look::label) {
        draw_mark(plot.canvas, series.look, {x, y}, series.size, css);
        if (!point.label.empty()) plot.labels.keep_free(x, y, series.size - 1.0);
    }
}

void draw_series(Plot& plot, const ChartSeries& series) {
    if (series.points.empty() || (series.look == Look::line && series.css.empty())) return;
    if (series.look == Look::line) return draw_line(plot, series);
    if (series.look == Look::band)
        return draw_box(plot, {plot.x(series.points.front().x), plot.top},
                        {plot.x(series.points.back().x), plot.bottom}, series.css);
    for (const ChartPoint& point : series.points)
        if (plot.holds(point) || (series.look == Look::bar && std::isfinite(point.x)))
            draw_point(plot, series, point);
}

void draw_labels(Plot& plot) {
    std::string drawn;
    for (const ChartSeries& series : plot.panel.series)
        for (const ChartPoint& point : series.points) {
            const bool line = series.look == Look::line, named = line && !series.css.empty();
            if (point.label.empty() || (named && point.label == drawn) || !plot.holds(point)) continue;
            const double x = plot.x(point.x), y = plot.y(point.y);
            const std::vector<TextPlace> places =
                line ? places_along(x, plot.x(series.points.back().x), y, series.side == LabelSide::above)
                     : places_around(x, y, text_width(point.label, series.font), series.font, series.side);
            if (plot.labels.draw(plot.canvas, point.label, places, series.label_css, series.font))
                drawn = point.label;
        }
}

/// Round ticks left and below, those of other units on the right.
void draw_axes(const Plot& plot) {
    draw_plot_frame(plot.canvas, plot.frame);
    const PlotAxis& up = plot.frame.vertical;
    if (!up.logarithmic && up.lower < 0.0 && up.upper > 0.0)
        plot.canvas.line(plot.left, plot.y(0.0), plot.right, plot.y(0.0), "zero");
    const double factor = plot.panel.beside_factor;
    if (!(factor > 0.0)) return;
    for (const PlotTick& tick : labelled_ticks(factor * up.lower, factor * up.upper, 6)) {
        const double y = plot.y(tick.value / factor);
        plot.canvas.line(plot.right, y, plot.right + 4, y, "frame");
        plot.canvas.text(plot.right + 8, y + 4, tick.words, "tick faint");
    }
}

/// A bar with its numbers at both ends.
void draw_colour_bar(const Plot& plot, const ColourScale& scale) {
    const double width = std::min(colour_bar_width, 0.45 * (plot.right - plot.left)),
                 left = plot.right - width, top = plot.top - 28, step = width / colour_steps;
    for (int i = 0; i < colour_steps; ++i)
        plot.canvas.rectangle(left + i * step, top, step + 0.3, colour_bar_height, fmt::format("c{}", i));
    plot.canvas.text(left, top + 20, short_text(scale.range.lower, 4), "tick");
    plot.canvas.text(plot.right, top + 20, short_text(scale.range.upper, 4), "tick right");
    if (!scale.title.empty()) plot.canvas.text(left - 12, top + 9, "colour: " + scale.title, "tick right");
}

/// Caption and note take one line where they fit.
bool fits_one_line(const ChartPanel& panel) {
    return text_width(panel.caption, caption_font, true) + text_width(panel.note, value_font) + 12.0 <
           panel.width;
}

void draw_plot(SvgCanvas& canvas, const ChartPanel& panel, double left, double top) {
    const double right = left + panel.width, bottom = top + panel.height;
    Plot plot{canvas, panel, panel.frame, left, top, right, bottom, {left, top - 2, right, bottom + 2}};
    plot.frame.horizontal.begin = left;
    plot.frame.horizontal.end = right;
    plot.frame.vertical.begin = bottom;
    plot.frame.vertical.end = top;
    canvas.text(left, fits_one_line(panel) ? top - 8 : top - 24, panel.caption, "caption");
    if (!panel.note.empty())
        canvas.text(right, top - 8, panel.note, panel.warning ? "warning end" : "note end");
    if (panel.drawn_axes) draw_axes(plot);
    for (const ChartSeries& series : panel.series) draw_series(plot, series);
    draw_labels(plot);
    if (panel.colours && !panel.colours->range.empty()) draw_colour_bar(plot, *panel.colours);
}

std::vector<std::string> head_lines(const ChartColumn& column) {
    const std::size_t end = column.head.find('\n');
    if (end == std::string::npos) return {column.head};
    return {column.head.substr(0, end), column.head.substr(end + 1)};
}

double width_of(const ChartColumn& column) {
    double width = 0.0;
    for (const std::string& line : head_lines(column))
        width = std::max(width, text_width(line, value_font, true));
    for (const auto& [words, css] : column.cells)
        width = std::max(width, text_width(words, value_font, css.ends_with("best")));
    return width;
}

void draw_table(SvgCanvas& canvas, const ChartPanel& table, double left, double top) {
    std::size_t lines = 1;
    for (const ChartColumn& column : table.columns) lines = std::max(lines, head_lines(column).size());
    canvas.text(left, top - 12 - head_line * static_cast<double>(lines), table.caption, "caption");
    for (const ChartColumn& column : table.columns) {
        const double width = width_of(column);
        const bool right = column.side == TextSide::end;
        const double x = right ? left + width : left;
        double y = top - 8 - head_line * static_cast<double>(head_lines(column).size() - 1);
        for (const std::string& line : head_lines(column)) {
            canvas.text(x, y, line, right ? "head" : "head left");
            y += head_line;
        }
        y = top + 0.5 * table.row_height + 4;
        for (const auto& [words, css] : column.cells) {
            if (!words.empty()) canvas.text(x, y, words, css + (right ? " end" : ""));
            y += table.row_height;
        }
        left += width + cell_gap;
    }
}

/// Axes, and the height of the frame, so that one unit is as long on both: what is too narrow is widened.
void equalise(ChartPanel& panel) {
    PlotAxis &across = panel.frame.horizontal, &up = panel.frame.vertical;
    const double unit = (across.upper - across.lower) / panel.width, wanted = (up.upper - up.lower) / unit;
    const double height = std::clamp(wanted, least_equal_height, panel.height);
    const auto widen = [](PlotAxis& axis, double size) {
        const double middle = 0.5 * (axis.lower + axis.upper);
        axis.lower = middle - 0.5 * size;
        axis.upper = middle + 0.5 * size;
    };
    if (wanted <= height)
        widen(up, unit * height);
    else
        widen(across, (up.upper - up.lower) / height * panel.width);
    panel.height = height;
}

/// What a panel takes around its frame; of a table, whose frame are its rows, around those.
struct Room {
    double left = 0.0, top = 8.0, right = 12.0, bottom = 4.0;
};

Room room_around(const ChartPanel& panel) {
    Room room;
    if (!panel.caption.empty()) room.top = fits_one_line(panel) ? 30 : 44;
    for (const ChartColumn& column : panel.columns)
        if (!column.head.empty() || !panel.caption.empty())
            room.top = std::max(room.top, (panel.caption.empty() ? 8 : 30) +
                                              head_line * static_cast<double>(head_lines(column).size()));
    if (!panel.columns.empty() || !panel.drawn_axes) return room;
    if (panel.rows == 0) room.left = room_before(panel.frame);
    if (panel.beside_factor > 0.0) room.right = 48;
    if (std::ranges::any_of(panel.frame.horizontal_ticks,
                            [](const auto& tick) { return !tick.words.empty(); }))
        room.bottom = panel.frame.horizontal_title.empty() ? 22 : 42;
    return room;
}

/// Ticks where it has none; the frame of a table is that of its rows.
void complete(ChartPanel& panel) {
    PlotFrame& frame = panel.frame;
    if (!panel.columns.empty()) {
        panel.rows = static_cast<int>(panel.columns.front().cells.size());
        panel.width = -cell_gap;
        for (const ChartColumn& column : panel.columns) panel.width += width_of(column) + cell_gap;
    }
    if (panel.rows > 0) {
        panel.height = panel.row_height * panel.rows;
        frame.vertical = {-static_cast<double>(panel.rows), 0.0};
    }
    set_axes(panel);
    if (panel.equal_scales) equalise(panel);
    if (frame.horizontal_ticks.empty())
        frame.horizontal_ticks = labelled_ticks(frame.horizontal, static_cast<int>(panel.width / 55));
    if (frame.vertical_ticks.empty() && panel.rows == 0)
        frame.vertical_ticks =
            labelled_ticks(frame.vertical, std::clamp(static_cast<int>(panel.height / 32), 1, 8));
}

/// Upper left corners of the frames, from the left upper corner of them all.
struct Layout {
    std::vector<TextPlace> corners;
    double width = 0.0, height = 0.0;
};

/// The frames of a row begin at one height.
Layout layout_of(const std::vector<ChartPanel>& panels) {
    using Place = ChartPanel::Place;
    Layout layout;
    double axis_room = 0.0, row_top = 0.0, column_left = 0.0, column_right = 0.0, y = 0.0;
    for (const ChartPanel& panel : panels) axis_room = std::max(axis_room, room_around(panel).left);
    for (auto panel = panels.begin(); panel != panels.end(); ++panel) {
        const Room room = room_around(*panel);
        if (panel->place == Place::new_row) {
            double top = room.top;
            for (auto next = panel + 1; next != panels.end() && next->place != Place::new_row; ++next)
                if (next->place == Place::right) top = std::max(top, room_around(*next).top);
            row_top = layout.height + (layout.corners.empty() ? 0.0 : row_gap) + top;
            column_left = column_right = 0.0;
        } else if (panel->place == Place::right) {
            column_left = column_right + (panel->rows > 0 ? cell_gap : column_gap);
        }
        y = panel->place == Place::below ? y + row_gap + room.top : row_top;
        const double left = column_left + (room.left > 0.0 ? axis_room : 0.0);
        layout.corners.push_back({left, y});
        y += panel->height + room.bottom;
        column_right = std::max(column_right, left + panel->width + room.right);
        layout.width = std::max(layout.width, column_right);
        layout.height = std::max(layout.height, y);
    }
    return layout;
}

/// Entries one after another, in as many lines as they take; returns the next baseline.
double draw_legend(SvgCanvas& canvas, const std::vector<ChartSeries>& legend, double y, double right) {
    double x = margin;
    for (const ChartSeries& entry : legend) {
        const bool wide = entry.look == Look::line || entry.look == Look::bar,
                   thin = entry.look == Look::tick || entry.look == Look::rule;
        const double half = wide ? 0.5 * sample_width : thin ? 1.0 : entry.size;
        const double width = 2.0 * half + 8 + text_width(entry.title, line_font);
        if (x > margin && x + width > right) {
            x = margin;
            y += legend_line;
        }
        draw_mark(canvas, entry.look, {x + half, thin ? y - 4 + entry.size : y - 4}, wide ? half : entry.size,
                  entry.css);
        canvas.text(x + 2.0 * half + 8, y, entry.title, "subtitle");
        x += width + 22;
    }
    return legend.empty() ? y : y + legend_line;
}

/// The series that have a title, each once.
std::vector<ChartSeries> legend_of(const Chart& chart) {
    std::vector<ChartSeries> legend;
    for (const ChartPanel& panel : chart.panels)
        for (const ChartSeries& series : panel.series)
            if (!series.title.empty() &&
                std::ranges::find(legend, series.title, &ChartSeries::title) == legend.end())
                legend.push_back({series.look, series.css, {}, series.size, series.title});
    return legend;
}

/// Returns the next baseline.
double draw_head(SvgCanvas& canvas, const Chart& chart, double room) {
    double y = 12.0;
    const auto add = [&](const std::string& words, const char* css, double font, double height) {
        if (words.empty()) return;
        for (const std::string& line : wrapped(words, room, font, font == title_font))
            canvas.text(margin, y += height, line, css);
    };
    add(chart.title, "title", title_font, title_line);
    y += 4;
    for (const std::string& line : chart.lines) add(line, "subtitle", line_font, text_line);
    return y + text_line + 2;
}

}  // namespace

std::string ColourScale::colour(double value) const {
    const double part = !(range.upper > range.lower) ? 0.5
                        : range.spans_factors()
                            ? std::log(value / range.lower) / std::log(range.upper / range.lower)
                            : (value - range.lower) / (range.upper - range.lower);
    return fmt::format("c{}", std::clamp(static_cast<int>(part * colour_steps), 0, colour_steps - 1));
}

void set_axes(ChartPanel& panel) {
    for (const bool across : {true, false}) {
        PlotAxis& axis = across ? panel.frame.horizontal : panel.frame.vertical;
        if (axis.upper > axis.lower) continue;
        ValueRange range, own;
        const auto add = [&](bool compared) {
            for (const ChartSeries& series : panel.series)
                for (const ChartPoint& point : series.points) {
                    const double value = across ? point.x : point.y;
                    if (series.compared != compared || !std::isfinite(value) ||
                        (axis.logarithmic && value <= 0.0))
                        continue;
                    range.add(compared ? std::max(0.5 * own.lower, std::min(value, 1.25 * own.upper))
                                       : value);
                }
        };
        add(false);
        own = range;
        add(true);
        if (range.empty())
            for (const double value : {0.1, 1.0}) range.add(value);
        axis = axis_over(range, axis.logarithmic || (panel.by_factors && range.spans_factors()));
    }
}

std::string palette_class(Look look, std::size_t index) {
    return fmt::format("{}{}", look == Look::line ? 'l' : 'p', index % palette.size());
}

std::string chart_svg(Chart chart) {
    for (ChartPanel& panel : chart.panels) complete(panel);
    const Layout layout = layout_of(chart.panels);
    const double width = std::max(layout.width + 2.0 * margin, least_page_width);
    SvgCanvas drawn;
    const double below_head = draw_head(drawn, chart, width - 2.0 * margin),
                 top = draw_legend(drawn, legend_of(chart), below_head, width - margin);
    for (std::size_t i = 0; i < chart.panels.size(); ++i)
        (chart.panels[i].columns.empty() ? draw_plot : draw_table)(
            drawn, chart.panels[i], margin + layout.corners[i].x, top + layout.corners[i].y);
    const double height = top + layout.height + 16;
    std::string style = chart_style();
    const auto is_band = [](const ChartSeries& series) { return series.css == "made"; };
    if (std::ranges::any_of(chart.panels, [&](const ChartPanel& panel) {
            return std::ranges::any_of(panel.series, is_band);
        }))
        style += ".made{fill:#0072b2;fill-opacity:.16;stroke:#0072b2;stroke-opacity:.4;stroke-width:.8}";
    SvgCanvas canvas(width, height, style, chart.title);
    canvas.rectangle(0, 0, width, height, "page");
    canvas.insert(0, 0, std::string(hatch) + drawn.elements());
    return canvas.finish();
}

}  // namespace camopt
