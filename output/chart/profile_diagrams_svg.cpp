// SPDX-License-Identifier: MIT
#include "output/chart/profile_diagrams_svg.hpp"

#include "core/units.hpp"
#include "output/chart/axis_ticks.hpp"
#include "output/chart/plot_frame.hpp"
#include "output/words/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace camopt {

namespace {

using units::degree, units::millimetre;

// Layout, px.
constexpr double page_width = 1000, page_height = 700, left = 84, right = 970, first_top = 84,
                 panel_height = 240, panel_distance = 310;
constexpr int steps = 2880;        // an eighth of a degree
constexpr double headroom = 0.16;  // of the range, above and below: for the labels
constexpr double limit_in_sight =
    2.5;  // a limit beyond this many times the largest value is left out of sight
constexpr double most_curvature = 6.0;  // of the largest of base circle's and limits' curvature: then cut off
constexpr double label_height = 24;     // px: of a mark's label with the mark
constexpr int angle_digits = 5;         // as in the report
constexpr double label_room = 130;      // px: nearer to the frame's end a label grows away from it

const char* page_style =
    ".caption{font-size:13px;font-weight:600}"
    ".knot{stroke:#c4c4c4;stroke-width:1;stroke-dasharray:2 3}"
    ".curve{fill:none;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:round}"
    ".limit{stroke:#c81e1e;stroke-width:1.6;stroke-dasharray:1.6 4;stroke-linecap:round}"
    ".limit-label{font-size:11.5px;fill:#c81e1e;paint-order:stroke;stroke:#fff;stroke-width:4px}"
    ".warning{fill:#d00000}.peak{fill:#0072b2;stroke:#fff;stroke-width:1.5}"
    ".peak-label{font-weight:600;fill:#005a8c;paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-"
    "linejoin:round}";

struct Line {
    double begin = 0.0, end = 0.0;  ///< deg
    double value = 0.0;
    std::string words;
};

struct Mark {
    double at = 0.0, value = 0.0;  ///< at: deg
    bool above = true;             ///< where the label stands
};

struct Panel {
    double top = 0.0;
    double least_range = 0.0;  ///< of the axis
    std::string caption, unit;
    std::function<double(const ProfilePoint&)> value;  ///< in the unit shown
    std::function<std::string(double value)> words;    ///< of an extreme
    std::vector<Line> limits;
    double bound = 0.0;                           ///< values beyond ± this are cut off; 0: none
    std::optional<std::vector<Mark>> marks = {};  ///< none: the extremes of the curve
};

using Pieces = std::vector<std::vector<ProfilePoint>>;

struct Extremes {
    double least = 0.0, most = 0.0, least_at = 0.0, most_at = 0.0;  ///< at: deg
};

Extremes extremes_of(const Pieces& pieces, const Panel& panel) {
    Extremes found{HUGE_VAL, -HUGE_VAL, 0.0, 0.0};
    for (const std::vector<ProfilePoint>& piece : pieces)
        for (const ProfilePoint& point : piece) {
            const double value = panel.value(point);
            if (value < found.least) found.least = value, found.least_at = point.theta / degree;
            if (value > found.most) found.most = value, found.most_at = point.theta / degree;
        }
    return found;
}

PlotAxis value_axis(const Panel& panel, const Extremes& extremes) {
    double lower = std::min(0.0, extremes.least), upper = std::max(0.0, extremes.most);
    if (panel.bound > 0.0) {
        lower = std::max(lower, -panel.bound);
        upper = std::min(upper, panel.bound);
    }
    const double size = std::max(upper, -lower);
    for (const Line& limit : panel.limits)
        if (std::abs(limit.value) < limit_in_sight * size) {
            lower = std::min(lower, limit.value);
            upper = std::max(upper, limit.value);
        }
    const double room = std::max(headroom * (upper - lower), 0.5 * (panel.least_range - upper + lower));
    return {lower - room, upper + room, panel.top + panel_height, panel.top};
}

PlotFrame frame_of(const ProfileShape& shape, const PlotAxis& vertical, const Panel& panel) {
    PlotFrame frame;
    frame.horizontal = {shape.begin() / degree, shape.end() / degree, left, right};
    frame.vertical = vertical;
    for (const double tick : degree_ticks(frame.horizontal.lower, frame.horizontal.upper, 13))
        frame.horizontal_ticks.push_back({tick, tick_text(tick, 1.0)});
    frame.vertical_ticks = labelled_ticks(vertical.lower, vertical.upper, 6);
    frame.vertical_title = panel.unit;
    return frame;
}

void draw_curve(SvgCanvas& canvas, const PlotFrame& frame, const Pieces& pieces, const Panel& panel) {
    std::string data;
    bool pen_down = false;
    for (const std::vector<ProfilePoint>& piece : pieces)
        for (const ProfilePoint& point : piece) {
            const double value = panel.value(point);
            const bool inside = frame.vertical.holds(value);
            if (inside)
                data += (pen_down ? "L" : "M") + svg_number(frame.horizontal.place(point.theta / degree)) +
                        " " + svg_number(frame.vertical.place(value));
            pen_down = inside;
        }
    canvas.path(data, "curve");
}

void draw_limits(SvgCanvas& canvas, const PlotFrame& frame, const Panel& panel,
                 const std::vector<Mark>& marks) {
    for (const Line& limit : panel.limits) {
        if (!frame.vertical.holds(limit.value)) continue;
        const double y = frame.vertical.place(limit.value), from = frame.horizontal.place(limit.begin);
        canvas.line(from, y, frame.horizontal.place(limit.end), y, "limit");
        const auto covers = [&](const Mark& mark) {
            return std::abs(frame.vertical.place(mark.value) - y) < label_height &&
                   frame.horizontal.place(mark.at) < from + 2.0 * label_room;
        };
        const bool at_end = std::ranges::any_of(marks, covers);
        canvas.text(at_end ? frame.horizontal.place(limit.end) - 6 : from + 6,
                    limit.value > 0.0 ? y - 6 : y + 15, limit.words,
                    at_end ? "limit-label end" : "limit-label");
    }
}

void draw_extreme(SvgCanvas& canvas, const PlotFrame& frame, const Panel& panel, const Mark& mark) {
    if (!frame.vertical.holds(mark.value) || mark.value == 0.0) return;
    const double x = frame.horizontal.place(mark.at), y = frame.vertical.place(mark.value);
    canvas.circle(x, y, 4, "peak");
    const bool at_left = x<left + label_room, at_right = x> right - label_room;
    const char* const css_class = at_left ? "peak-label" : at_right ? "peak-label end" : "peak-label middle";
    canvas.text(at_left    ? std::max(x, left + 6)
                : at_right ? std::min(x, right - 6)
                           : x,
                mark.above ? y - 9 : y + 19,
                fmt::format("{} at {}°", panel.words(mark.value), short_text(mark.at, angle_digits)),
                css_class);
}

void draw_panel(SvgCanvas& canvas, const ProfileShape& shape, const Pieces& pieces, const Panel& panel) {
    const Extremes extremes = extremes_of(pieces, panel);
    const PlotFrame frame = frame_of(shape, value_axis(panel, extremes), panel);
    draw_plot_frame(canvas, frame);
    for (const double knot : shape.knots) {
        const double x = frame.horizontal.place(knot / degree);
        canvas.line(x, panel.top, x, panel.top + panel_height, "knot");
    }
    canvas.line(left, frame.vertical.place(0.0), right, frame.vertical.place(0.0), "zero");
    draw_curve(canvas, frame, pieces, panel);
    const std::vector<Mark> marks = panel.marks.value_or(std::vector<Mark>{
        {extremes.most_at, extremes.most, true}, {extremes.least_at, extremes.least, false}});
    draw_limits(canvas, frame, panel, marks);
    for (const Mark& mark : marks) draw_extreme(canvas, frame, panel, mark);
    canvas.text(left, panel.top - 9, panel.caption, "caption");
    if (!frame.vertical.holds(extremes.most) || !frame.vertical.holds(extremes.least))
        canvas.text(right, panel.top - 9, "it leaves the frame", "warning end");
}

Panel pressure_panel(const ProfileDiagramLimits& limits) {
    Panel panel;
    panel.top = first_top;
    panel.least_range = 2.0;
    panel.caption = "Pressure angle φ";
    panel.unit = "deg";
    panel.value = [](const ProfilePoint& point) { return point.pressure_angle / degree; };
    panel.words = [](double value) { return fmt::format("φ = {}°", short_text(value, 4)); };
    for (const PressureLimit& limit : limits.pressure)
        for (const double sign : {1.0, -1.0})
            panel.limits.push_back(
                {limit.begin / degree, limit.end / degree, sign * limit.limit / degree,
                 sign > 0.0 ? fmt::format("limit {}°", short_text(limit.limit / degree)) : ""});
    return panel;
}

Panel curvature_panel(const ProfileShape& shape, const ProfileDiagramLimits& limits) {
    Panel panel;
    panel.top = first_top + panel_distance;
    panel.caption = "Curvature of the cam 1/ρ (convex > 0, concave < 0)";
    panel.unit = "1/mm";
    panel.value = [](const ProfilePoint& point) { return millimetre / point.cam_radius; };
    panel.words = [](double value) { return fmt::format("ρ = {} mm", short_text(1.0 / value, 4)); };
    panel.bound = most_curvature * millimetre / shape.cam[DimensionIndex::base_radius];
    const auto add = [&](const std::optional<double>& radius, double sign, const char* name) {
        if (!radius || !(*radius > 0.0)) return;
        const double value = sign * millimetre / *radius;
        panel.bound = std::max(panel.bound, 1.5 * std::abs(value));
        panel.limits.push_back(
            {shape.begin() / degree, shape.end() / degree, value,
             fmt::format("least {} radius {} mm", name, short_text(*radius / millimetre))});
    };
    add(limits.convex_radius_min, 1.0, "convex");
    add(limits.concave_radius_min, -1.0, "concave");
    return panel;
}

/// factor: from SI to the unit shown.
std::vector<Mark> shown_marks(const std::vector<ProfileMark>& marks, double factor) {
    std::vector<Mark> shown;
    for (const ProfileMark& mark : marks)
        shown.push_back({mark.theta / degree, factor * mark.value, mark.value > 0.0});
    return shown;
}

}  // namespace

std::string profile_diagrams_svg(const ProfileShape& shape, const ProfileDiagramLimits& limits,
                                 std::string_view title, const std::optional<ProfileDiagramMarks>& marks) {
    const Pieces pieces = profile_pieces(shape, steps);
    SvgCanvas canvas(page_width, page_height, page_style, title);
    canvas.rectangle(0, 0, page_width, page_height, "page");
    canvas.text(left, 38, title, "title");
    Panel pressure = pressure_panel(limits), curvature = curvature_panel(shape, limits);
    if (marks) {
        pressure.marks = shown_marks(marks->pressure, 1.0 / degree);
        curvature.marks = shown_marks(marks->curvature, millimetre);
    }
    draw_panel(canvas, shape, pieces, pressure);
    draw_panel(canvas, shape, pieces, curvature);
    canvas.text(0.5 * (left + right), page_height - 20, "cam angle θ (deg)", "middle");
    return canvas.finish();
}

}  // namespace camopt
