// SPDX-License-Identifier: MIT
#include "output/chart/turn_diagram.hpp"

#include "output/chart/axis_ticks.hpp"
#include "output/chart/placed_texts.hpp"
#include "output/chart/plot_frame.hpp"
#include "output/chart/svg_canvas.hpp"
#include "output/words/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

// Layout, px.
constexpr double page_width = 1000, left = 84, right = 970, first_top = 84, panel_height = 240,
                 panel_distance = 310, below_panels = 4;
constexpr double diagram_headroom = 0.16;  // of the range, above and below: for the labels
constexpr double diagram_limit_in_sight =
    2.5;  // a limit beyond this many times the largest value is left out of sight
constexpr double peak_font = 12, limit_font = 11.5;  // px
constexpr int mark_digits = 5;                       // as in the report

const char* turn_style =
    ".caption{font-size:13px;font-weight:600}"
    ".knot{stroke:#c4c4c4;stroke-width:1;stroke-dasharray:2 3}"
    ".curve{fill:none;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:round}"
    ".limit{stroke:#c81e1e;stroke-width:1.6;stroke-dasharray:1.6 4;stroke-linecap:round}"
    ".limit-label{font-size:11.5px;fill:#c81e1e;paint-order:stroke;stroke:#fff;stroke-width:4px}"
    ".warning{fill:#d00000}.peak{fill:#0072b2;stroke:#fff;stroke-width:1.5}"
    ".peak-label{font-weight:600;fill:#005a8c;paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-"
    "linejoin:round}";

struct Extremes {
    double least = 0.0, most = 0.0, least_at = 0.0, most_at = 0.0;  ///< at: deg
};

Extremes extremes_of(const TurnPanel& panel) {
    Extremes found{HUGE_VAL, -HUGE_VAL, 0.0, 0.0};
    for (const std::vector<Eigen::Vector2d>& piece : panel.pieces)
        for (const Eigen::Vector2d& point : piece) {
            if (point.y() < found.least) found.least = point.y(), found.least_at = point.x();
            if (point.y() > found.most) found.most = point.y(), found.most_at = point.x();
        }
    return found;
}

PlotAxis value_axis(const TurnPanel& panel, const Extremes& extremes, double top) {
    double lower = std::min(0.0, extremes.least), upper = std::max(0.0, extremes.most);
    if (panel.bound > 0.0) {
        lower = std::max(lower, -panel.bound);
        upper = std::min(upper, panel.bound);
    }
    const double size = std::max(upper, -lower);
    for (const TurnLimit& limit : panel.limits)
        if (std::abs(limit.value) < diagram_limit_in_sight * size) {
            lower = std::min(lower, limit.value);
            upper = std::max(upper, limit.value);
        }
    const double room =
        std::max(diagram_headroom * (upper - lower), 0.5 * (panel.least_range - upper + lower));
    return {lower - room, upper + room, top + panel_height, top};
}

PlotFrame frame_of(const TurnDiagram& diagram, const PlotAxis& vertical, const TurnPanel& panel) {
    PlotFrame frame;
    frame.horizontal = {diagram.begin, diagram.end, left, right};
    frame.vertical = vertical;
    for (const double tick : degree_ticks(frame.horizontal.lower, frame.horizontal.upper, 13))
        frame.horizontal_ticks.push_back({tick, tick_text(tick, 1.0)});
    frame.vertical_ticks = labelled_ticks(vertical.lower, vertical.upper, 6);
    frame.vertical_title = panel.unit;
    return frame;
}

void draw_curve(SvgCanvas& canvas, const PlotFrame& frame, const TurnPanel& panel) {
    std::string data;
    bool pen_down = false;
    for (const std::vector<Eigen::Vector2d>& piece : panel.pieces)
        for (const Eigen::Vector2d& point : piece) {
            const bool inside = frame.vertical.holds(point.y());
            if (inside)
                data += (pen_down ? "L" : "M") + svg_number(frame.horizontal.place(point.x())) + " " +
                        svg_number(frame.vertical.place(point.y()));
            pen_down = inside;
        }
    canvas.path(data, "curve");
}

/// Above or below the line, at its beginning, its end, or between.
void draw_limits(SvgCanvas& canvas, const PlotFrame& frame, const TurnPanel& panel, PlacedTexts& labels) {
    for (const TurnLimit& limit : panel.limits) {
        if (!frame.vertical.holds(limit.value)) continue;
        const double y = frame.vertical.place(limit.value), from = frame.horizontal.place(limit.begin),
                     to = frame.horizontal.place(limit.end), middle = 0.5 * (from + to);
        canvas.line(from, y, to, y, "limit");
        if (limit.words.empty()) continue;
        std::vector<TextPlace> places;
        for (const bool outside : {true, false}) {
            const double base = (limit.value > 0.0) == outside ? y - 6 : y + 15;
            places.push_back({from + 6, base, TextSide::start});
            places.push_back({to - 6, base, TextSide::end});
            places.push_back({middle, base, TextSide::middle});
            places.push_back({to + 6, base, TextSide::start});
            places.push_back({from - 6, base, TextSide::end});
        }
        labels.draw(canvas, limit.words, places, "limit-label", limit_font);
    }
}

/// Beside its mark; where others stand there, farther away from it or to its side.
void draw_extreme(SvgCanvas& canvas, const PlotFrame& frame, const TurnPanel& panel, const TurnMark& mark,
                  PlacedTexts& labels) {
    if (!frame.vertical.holds(mark.value) || mark.value == 0.0) return;
    const double x = frame.horizontal.place(mark.at), y = frame.vertical.place(mark.value);
    canvas.circle(x, y, 4, "peak");
    std::vector<TextPlace> places;
    for (const bool as_wished : {true, false})
        for (const double farther : {0.0, 16.0}) {
            const double base = mark.above == as_wished ? y - 9 - farther : y + 19 + farther;
            places.push_back({x, base, TextSide::middle});
            places.push_back({std::max(x, left + 6), base, TextSide::start});
            places.push_back({std::min(x, right - 6), base, TextSide::end});
        }
    places.push_back({x + 9, y + 4, TextSide::start});
    places.push_back({x - 9, y + 4, TextSide::end});
    labels.draw(canvas, fmt::format("{} at {}°", panel.words(mark.value), short_text(mark.at, mark_digits)),
                places, "peak-label", peak_font, true);
}

void draw_turn_panel(SvgCanvas& canvas, const TurnDiagram& diagram, const TurnPanel& panel, double top) {
    const Extremes extremes = extremes_of(panel);
    const PlotFrame frame = frame_of(diagram, value_axis(panel, extremes, top), panel);
    draw_plot_frame(canvas, frame);
    for (const double knot : diagram.knots) {
        const double x = frame.horizontal.place(knot);
        canvas.line(x, top, x, top + panel_height, "knot");
    }
    canvas.line(left, frame.vertical.place(0.0), right, frame.vertical.place(0.0), "zero");
    draw_curve(canvas, frame, panel);
    const std::vector<TurnMark> marks = panel.marks.value_or(std::vector<TurnMark>{
        {extremes.most_at, extremes.most, true}, {extremes.least_at, extremes.least, false}});
    PlacedTexts labels(left, top - 2, right, top + panel_height + 2);
    for (const TurnMark& mark : marks) draw_extreme(canvas, frame, panel, mark, labels);
    draw_limits(canvas, frame, panel, labels);
    canvas.text(left, top - 9, panel.caption, "caption");
    if (!frame.vertical.holds(extremes.most) || !frame.vertical.holds(extremes.least))
        canvas.text(right, top - 9, "beyond the frame", "warning end");
}

}  // namespace

std::string turn_diagram_svg(const TurnDiagram& diagram) {
    const double page_height =
        first_top + panel_distance * static_cast<double>(diagram.panels.size()) - below_panels;
    SvgCanvas canvas(page_width, page_height, turn_style, diagram.title);
    canvas.rectangle(0, 0, page_width, page_height, "page");
    canvas.text(left, 38, diagram.title, "title");
    double top = first_top;
    for (const TurnPanel& panel : diagram.panels) {
        draw_turn_panel(canvas, diagram, panel, top);
        top += panel_distance;
    }
    canvas.text(0.5 * (left + right), page_height - 20, "cam angle θ (deg)", "middle");
    return canvas.finish();
}

}  // namespace camopt
