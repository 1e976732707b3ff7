// SPDX-License-Identifier: MIT
#include "output/chart/curve_chart.hpp"

#include "core/errors.hpp"
#include "output/chart/axis_ticks.hpp"
#include "output/chart/placed_texts.hpp"
#include "output/chart/plot_frame.hpp"
#include "output/chart/svg_canvas.hpp"
#include "output/view/number_text.hpp"
#include "output/words/solution_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

// Layout, px.
constexpr double page_width = 1000, left = 92, right = 924, panel_height = 196, panel_distance = 248,
                 first_line = 58, text_line = 17, below_lines = 44, below_panels = 56;
constexpr double headroom = 0.17;       // of the range, above and below: for the labels
constexpr double limit_in_sight = 2.0;  // a limit beyond this many times the largest value is not drawn
constexpr double below_zero = 0.02;     // of the largest value: less than this is no negative value
constexpr double least_drawn = 0.3;     // px: a step shorter than this is not drawn
constexpr std::size_t most_breakpoints = 200;  // more would be a grey band
constexpr double mark_font = 12, limit_font = 11.5, caption_font = 14, note_font = 12, line_font = 13;
constexpr int angle_digits_of_mark = 5;  // as in the report

const char* const chart_style =
    ".unit,.note{fill:#555}.axis{stroke:#8a8a8a;stroke-width:1}"
    ".segment{stroke:#555;stroke-width:1;stroke-dasharray:8 3}"
    ".segment-label{font-size:11.5px;fill:#444;paint-order:stroke;stroke:#fff;stroke-width:4px}"
    ".breakpoint{stroke:#9a9a9a;stroke-width:1}"
    ".optimum{fill:none;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:round}"
    ".reference{fill:none;stroke:#6b6b6b;stroke-width:1.5;stroke-dasharray:6 4}"
    ".measured{fill:none;stroke:#009e73;stroke-width:1.5;stroke-dasharray:2 2.5}"
    ".set-point{fill:#fff;stroke:#d55e00;stroke-width:1.8}"
    ".set-region{stroke:#d55e00;stroke-width:5;stroke-opacity:.35}"
    ".limit{stroke:#c81e1e;stroke-width:1.6;stroke-dasharray:1.6 4;stroke-linecap:round}"
    ".limit-label{font-size:11.5px;fill:#c81e1e;paint-order:stroke;stroke:#fff;stroke-width:4px}"
    ".warning{fill:#d00000}.peak{fill:#0072b2;stroke:#fff;stroke-width:1.5}"
    ".peak-label{font-weight:600;fill:#005a8c;paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-"
    "linejoin:round}";

PlotAxis value_axis(const Curve& curve, double top) {
    ValueRange range;
    range.add(0.0);
    for (const double value : curve.values) range.add(value);
    for (const CurveMark& mark : curve.marks) range.add(mark.value);
    for (const auto* other : {&curve.reference, &curve.measured})
        if (*other)
            for (const double value : (*other)->values) range.add(value);
    const double size = std::max(range.upper, -range.lower);
    const bool falls = range.lower<-below_zero * size, rises = range.upper> below_zero * size;
    for (const CurveLimit& limit : curve.limits)
        if (std::abs(limit.at) <= limit_in_sight * size && (limit.at > 0.0 ? rises : falls))
            range.add(limit.at);
    const double width = range.upper > range.lower ? range.upper - range.lower : 1.0;
    return {range.lower - headroom * width, range.upper + headroom * width, top + panel_height, top};
}

/// One panel on its way to the canvas.
struct Panel {
    SvgCanvas& canvas;
    const View& view;
    const Curve& curve;
    PlotFrame frame;
    std::size_t rows = 0;  ///< those that are drawn
    double top = 0.0, bottom = 0.0;
    PlacedTexts labels;

    [[nodiscard]] double x(double degrees) const { return frame.horizontal.place(degrees); }
    [[nodiscard]] double y(double value) const { return frame.vertical.place(value); }
    [[nodiscard]] bool holds(double value) const { return frame.vertical.holds(value); }
};

std::size_t rows_drawn(const View& view, const CurveChart& chart) {
    const std::vector<DeliveredRow>& rows = view.delivered.rows;
    const auto closing = std::ranges::find(rows, true, &DeliveredRow::closing);
    return chart.closed ? rows.size() : static_cast<std::size_t>(closing - rows.begin());
}

/// The lowest one carries the numbers of the cam angle.
Panel panel_at(SvgCanvas& canvas, const View& view, const CurveChart& chart, std::size_t index, double top) {
    const std::size_t rows = rows_drawn(view, chart);
    const bool lowest = index + 1 == chart.panels.size();
    PlotFrame frame;
    frame.horizontal = {view.angles.front(), view.angles[rows - 1], left, right};
    frame.vertical = value_axis(*chart.panels[index], top);
    for (const double tick : degree_ticks(frame.horizontal.lower, frame.horizontal.upper, 13))
        frame.horizontal_ticks.push_back({tick, lowest ? tick_text(tick, 1.0) : ""});
    frame.vertical_ticks = labelled_ticks(frame.vertical.lower, frame.vertical.upper, 6);
    return {canvas, view, *chart.panels[index], std::move(frame),
            rows,   top,  top + panel_height,   {left, top - 2, right, top + panel_height + 2}};
}

/// Normalised values on the right, the unit on the left.
void draw_axes(const Panel& panel) {
    draw_plot_frame(panel.canvas, panel.frame);
    panel.canvas.line(left, panel.y(0.0), right, panel.y(0.0), "zero");
    panel.canvas.text(left - 66, 0.5 * (panel.top + panel.bottom), panel.curve.unit.name, "unit middle", 90);
    const double factor = panel.curve.normalised_factor;
    if (!(factor > 0.0)) return;
    const PlotAxis& axis = panel.frame.vertical;
    for (const PlotTick& tick : labelled_ticks(factor * axis.lower, factor * axis.upper, 6)) {
        const double y = panel.y(tick.value / factor);
        panel.canvas.line(right, y, right + 4, y, "axis");
        panel.canvas.text(right + 8, y + 4, tick.words, "tick faint");
    }
}

void draw_segments(Panel& panel, bool titles) {
    for (const ViewSegment& segment : panel.view.segments) {
        const double begin = panel.x(segment.from), end = panel.x(segment.to), middle = 0.5 * (begin + end);
        if (begin > left) panel.canvas.line(begin, panel.top, begin, panel.bottom, "segment");
        if (titles && text_width(segment.title, limit_font) < end - begin)
            panel.labels.draw(panel.canvas, segment.title,
                              std::vector<TextPlace>{{middle, panel.bottom - 8, TextSide::middle},
                                                     {middle, panel.top + 14, TextSide::middle}},
                              "segment-label", limit_font);
    }
    if (panel.view.breakpoints.size() > most_breakpoints) return;
    for (const double at : panel.view.breakpoints)
        panel.canvas.line(panel.x(at), panel.bottom - 5, panel.x(at), panel.bottom, "breakpoint");
}

void draw_values(const Panel& panel, const std::vector<double>& values, const char* css_class) {
    std::string data;
    bool pen_down = false;
    double last_x = 0.0, last_y = 0.0;
    for (std::size_t i = 0; i < panel.rows; ++i) {
        const bool inside = panel.holds(values[i]);  // false for NaN
        if (inside) {
            const double x = panel.x(panel.view.angles[i]), y = panel.y(values[i]);
            const bool far = std::abs(x - last_x) >= least_drawn || std::abs(y - last_y) >= least_drawn;
            if (!pen_down || far || i + 1 == panel.rows) {
                data += (pen_down ? "L" : "M") + svg_number(x) + " " + svg_number(y);
                last_x = x;
                last_y = y;
            }
        }
        pen_down = inside;
    }
    if (!data.empty()) panel.canvas.path(data, css_class);
}

/// A set point as an open square, a region as a thick line between two of them.
void draw_set_points(const Panel& panel) {
    constexpr double half = 4.0;
    for (const CurveMark& mark : panel.curve.marks) {
        if (!mark.given) continue;
        const double y = panel.y(mark.value), end = mark.to.value_or(mark.at);
        if (mark.to) panel.canvas.line(panel.x(mark.at), y, panel.x(end), y, "set-region");
        for (const double at : {mark.at, end})
            panel.canvas.rectangle(panel.x(at) - half, y - half, 2.0 * half, 2.0 * half, "set-point");
    }
}

/// The label is beside its mark; where other labels are, further from it or to its side.
void draw_extremes(Panel& panel) {
    for (const CurveMark& mark : panel.curve.marks) {
        if (mark.given || !panel.holds(mark.value) || mark.value == 0.0) continue;
        const double x = panel.x(mark.at), y = panel.y(mark.value);
        panel.canvas.circle(x, y, 4, "peak");
        std::vector<TextPlace> places;
        for (const bool outwards : {true, false})
            for (const double further : {0.0, 16.0}) {
                const double base = (mark.value > 0.0) == outwards ? y - 9 - further : y + 19 + further;
                places.push_back({x, base, TextSide::middle});
                places.push_back({std::max(x, left + 6), base, TextSide::start});
                places.push_back({std::min(x, right - 6), base, TextSide::end});
            }
        places.push_back({x + 9, y + 4, TextSide::start});
        places.push_back({x - 9, y + 4, TextSide::end});
        panel.labels.draw(panel.canvas,
                          fmt::format("{} at {}°", mark.words, short_text(mark.at, angle_digits_of_mark)),
                          places, "peak-label", mark_font, true);
    }
}

/// Above or below the line, at its beginning, its end, or between. Of two lines of one limit one is named.
void draw_limits(Panel& panel) {
    std::string named;
    for (const CurveLimit& limit : panel.curve.limits) {
        if (!panel.holds(limit.at)) {
            if (limit.at > 0.0 && limit.words != named)
                panel.labels.draw(panel.canvas, limit.words + " lies outside",
                                  std::vector<TextPlace>{{right - 6, panel.top + 14, TextSide::end},
                                                         {left + 6, panel.top + 14, TextSide::start}},
                                  "limit-label", limit_font);
            if (limit.at > 0.0) named = limit.words;
            continue;
        }
        const double y = panel.y(limit.at), from = panel.x(limit.from), to = panel.x(limit.to);
        panel.canvas.line(from, y, to, y, "limit");
        if (limit.words == named) continue;
        std::vector<TextPlace> places;
        for (const bool outwards : {true, false}) {
            const double base = (limit.at > 0.0) == outwards ? y - 6 : y + 15;
            places.push_back({from + 6, base, TextSide::start});
            places.push_back({to - 6, base, TextSide::end});
            places.push_back({0.5 * (from + to), base, TextSide::middle});
            places.push_back({to + 6, base, TextSide::start});
            places.push_back({from - 6, base, TextSide::end});
        }
        if (panel.labels.draw(panel.canvas, limit.words, places, "limit-label", limit_font))
            named = limit.words;
    }
}

/// Title and note in one line where they fit.
void draw_caption(const Panel& panel) {
    const Curve& curve = panel.curve;
    const bool leaves = !std::ranges::all_of(curve.values, [](double value) { return std::isfinite(value); });
    const std::string caption = fmt::format("{} ({})", curve.title, curve.symbol),
                      note = leaves && curve.note.empty() ? "it leaves the frame" : curve.note;
    const bool both =
        text_width(caption, caption_font, true) + text_width(note, note_font) + 12.0 < right - left;
    panel.canvas.text(left, both ? panel.top - 8 : panel.top - 24, caption, "caption");
    panel.canvas.text(right, panel.top - 8, note, leaves ? "warning end" : "note end");
}

void draw_panel(Panel panel, bool first) {
    draw_axes(panel);
    const Curve& curve = panel.curve;
    if (curve.measured) draw_values(panel, curve.measured->values, "measured");
    if (curve.reference) draw_values(panel, curve.reference->values, "reference");
    draw_values(panel, curve.values, "optimum");
    draw_set_points(panel);
    draw_extremes(panel);
    draw_limits(panel);
    draw_segments(panel, first);
    draw_caption(panel);
}

void draw_legend(SvgCanvas& canvas, const View& view, const CurveChart& chart, double y) {
    double x = left;
    const auto words = [&](double room, const std::string& text) {
        canvas.text(x + room, y, text, "subtitle");
        x += room + text_width(text, line_font) + 22;
    };
    const auto line = [&](const char* css_class, const std::string& text) {
        canvas.line(x, y - 4, x + 30, y - 4, css_class);
        words(37, text);
    };
    const auto any = [&](const auto& has) { return std::ranges::any_of(chart.panels, has); };
    line("optimum", "this motion");
    if (const auto& reference = chart.panels.front()->reference) line("reference", reference->title);
    if (const auto& measured = chart.panels.front()->measured) line("measured", measured->title);
    if (any([](const Curve* curve) { return !curve->limits.empty(); })) line("limit", "limit");
    canvas.circle(x + 4, y - 4, 4, "peak");
    words(15, "peaks");
    if (any([](const Curve* curve) { return std::ranges::any_of(curve->marks, &CurveMark::given); })) {
        canvas.rectangle(x, y - 8, 8, 8, "set-point");
        words(15, "set points");
    }
    if (!view.segments.empty()) {
        canvas.line(x, y - 11, x, y + 3, "segment");
        words(8, "segments");
    }
    canvas.line(x, y - 7, x, y - 1, "breakpoint");
    words(8, fmt::format("breakpoints ({})", view.breakpoints.size()));
}

/// Broken at its last " · " that fits.
void add_line(std::vector<std::string>& lines, std::string words) {
    constexpr std::string_view dot = " · ";
    while (text_width(words, line_font) > page_width - left - 8) {
        std::size_t end = words.size();
        do end = end == 0 ? std::string::npos : words.rfind(dot, end - 1);
        while (end != std::string::npos && end > 0 &&
               text_width(words.substr(0, end), line_font) > page_width - left - 8);
        if (end == 0 || end == std::string::npos) break;
        lines.push_back(words.substr(0, end));
        words.erase(0, end + dot.size());
    }
    lines.push_back(std::move(words));
}

}  // namespace

std::vector<const Curve*> curves_of(const View& view, std::string_view group, std::string_view key) {
    std::vector<const Curve*> found;
    for (const Curve& curve : view.curves)
        if (curve.group == group && curve.key.starts_with(key)) found.push_back(&curve);
    return found;
}

std::string curve_chart_svg(const View& view, const CurveChart& chart) {
    const double head = first_line + text_line * static_cast<double>(chart.lines.size());
    const double first = head + (chart.legend ? below_lines : below_lines - text_line);
    const double page_height = first + panel_distance * (static_cast<double>(chart.panels.size()) - 1.0) +
                               panel_height + below_panels;
    SvgCanvas canvas(page_width, page_height, chart_style, chart.title);
    canvas.rectangle(0, 0, page_width, page_height, "page");
    canvas.text(left, 36, chart.title, "title");
    for (std::size_t i = 0; i < chart.lines.size(); ++i)
        canvas.text(left, first_line + text_line * static_cast<double>(i), chart.lines[i], "subtitle");
    if (chart.legend) draw_legend(canvas, view, chart, head + 4);
    for (std::size_t i = 0; i < chart.panels.size(); ++i) {
        const double top = first + panel_distance * static_cast<double>(i);
        draw_panel(panel_at(canvas, view, chart, i, top), i == 0);
    }
    canvas.text(0.5 * (left + right), page_height - 16, "cam angle θ (deg)", "unit middle");
    return canvas.finish();
}

std::string motion_svg(const View& view) {
    if (!view.solution.motion) throw InputError("motion.svg needs a motion, and this solution has none");
    CurveChart chart{view.title("Motion"), {}, true, false, curves_of(view, "motion")};
    add_line(chart.lines, verdict_sentence(view.solution));
    add_line(chart.lines, objective_line(view.solution, " · "));
    chart.lines.push_back(
        fmt::format("Left axis: physical units. Right axis: normalised by lift and {}.",
                    view.segments.empty() ? "rise" : "the angle of the first spline segment"));
    return curve_chart_svg(view, chart);
}

std::string cam_diagrams_svg(const View& view, std::string_view key) {
    return curve_chart_svg(view, {view.title("Cam"), {}, false, true, curves_of(view, "cam", key)});
}

std::string force_diagrams_svg(const View& view) {
    std::vector<const Curve*> curves = curves_of(view, "forces");
    if (curves.empty()) throw InputError("forces.svg needs forces, and this solution has none");
    const std::string& title = view.solution.scene.title;
    return curve_chart_svg(
        view, {title.empty() ? "Forces" : title + ": forces", {}, false, true, std::move(curves)});
}

}  // namespace camopt
