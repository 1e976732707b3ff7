// SPDX-License-Identifier: MIT
#include "output/chart/motion_panel.hpp"

#include "output/chart/axis_ticks.hpp"
#include "output/chart/placed_texts.hpp"
#include "output/chart/plot_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr double caption_font = 14, compare_font = 12;  // px
constexpr double headroom = 0.17;  // of the value range, above and below: room for the peak's label
constexpr double limit_in_sight =
    1.45;  // a limit beyond this many times the largest value is left out of sight
constexpr std::size_t most_breakpoint_ticks = 200;  // more would be a grey band
constexpr double title_character = 7.0;             // px: width of a letter of a segment's title
constexpr double edge = 120;         // px: nearer to the frame's end a peak's label grows away from it
constexpr double below_zero = 0.02;  // of the largest value: less than this is not a motion downwards

/// The panel's coordinates.
struct Plot {
    PanelFrame frame;
    double begin = 0.0, end = 0.0, lower = 0.0, upper = 0.0;
    [[nodiscard]] double x(double angle) const {
        return frame.left + frame.width * (angle - begin) / (end - begin);
    }
    [[nodiscard]] double y(double value) const {
        return frame.top + frame.height * (upper - value) / (upper - lower);
    }
    [[nodiscard]] double right() const { return frame.left + frame.width; }
    [[nodiscard]] double bottom() const { return frame.top + frame.height; }
};

Plot make_plot(const PanelFrame& frame, const PanelContent& content) {
    ValueRange range = value_range(*content.optimum, content.order);
    for (const PanelPeak& peak : content.peaks) {
        range.lower = std::min(range.lower, peak.where.value);
        range.upper = std::max(range.upper, peak.where.value);
    }
    for (const Motion* beside : {content.reference, content.measured}) {
        if (!beside) continue;
        const ValueRange other = value_range(*beside, content.order);
        range.lower = std::min(range.lower, other.lower);
        range.upper = std::max(range.upper, other.upper);
    }
    for (const PanelMark& mark : content.marks) {
        range.lower = std::min(range.lower, mark.value);
        range.upper = std::max(range.upper, mark.value);
    }
    if (content.limit && content.limit->normalised <= limit_in_sight * std::max(range.upper, -range.lower)) {
        range.upper = std::max(range.upper, content.limit->normalised);
        if (range.lower < -below_zero * range.upper)
            range.lower = std::min(range.lower, -content.limit->normalised);
    }
    const double size = range.upper > range.lower ? range.upper - range.lower : 1.0;
    return {frame, content.optimum->begin(), content.optimum->end(), range.lower - headroom * size,
            range.upper + headroom * size};
}

/// The left axis carries physical units and the grid, the right one normalised values.
void draw_value_axes(SvgCanvas& canvas, const Plot& plot, const PanelContent& content) {
    for (const PlotTick& tick : labelled_ticks(content.factor * plot.lower, content.factor * plot.upper, 6)) {
        const double y = plot.y(tick.value / content.factor);
        canvas.line(plot.frame.left, y, plot.right(), y, tick.value == 0.0 ? "zero" : "grid");
        canvas.text(plot.frame.left - 8, y + 4, tick.words, "tick end");
    }
    for (const PlotTick& tick : labelled_ticks(plot.lower, plot.upper, 6)) {
        const double y = plot.y(tick.value);
        canvas.line(plot.right(), y, plot.right() + 4, y, "axis");
        canvas.text(plot.right() + 8, y + 4, tick.words, "tick faint");
    }
    const double middle = plot.frame.top + 0.5 * plot.frame.height;
    canvas.text(plot.frame.left - 66, middle, content.unit, "unit middle", 90);
}

void draw_angle_axis(SvgCanvas& canvas, const Plot& plot, const PanelContent& content) {
    const double step =
        content.angle_ticks.size() > 1 ? content.angle_ticks[1] - content.angle_ticks[0] : 1.0;
    for (const double tick : content.angle_ticks) {
        const double x = plot.x(tick / content.degrees_per_x);
        canvas.line(x, plot.frame.top, x, plot.bottom(), "grid");
        if (content.angle_labels) canvas.text(x, plot.bottom() + 18, tick_text(tick, step), "tick middle");
    }
    const std::vector<double> breakpoints = content.optimum->breakpoints();
    if (breakpoints.size() > most_breakpoint_ticks) return;
    for (const double breakpoint : breakpoints)
        canvas.line(plot.x(breakpoint), plot.bottom() - 5, plot.x(breakpoint), plot.bottom(), "breakpoint");
}

void draw_segments(SvgCanvas& canvas, const Plot& plot, const PanelContent& content) {
    for (const PanelSegment& segment : content.segments) {
        const double begin = plot.x(segment.begin), end = plot.x(segment.end);
        if (segment.begin > plot.begin) canvas.line(begin, plot.frame.top, begin, plot.bottom(), "segment");
        const double room = title_character * static_cast<double>(segment.title.size());
        if (!segment.title.empty() && room < end - begin)
            canvas.text(0.5 * (begin + end), plot.bottom() - 8, segment.title, "segment-label middle");
    }
}

/// One level of a limit over a stretch of the motion, above and, where the panel reaches it, below zero.
void draw_level(SvgCanvas& canvas, const Plot& plot, const LimitSpan& span) {
    for (const double value : {span.normalised, -span.normalised})
        if (value >= plot.lower && value <= plot.upper)
            canvas.line(plot.x(span.begin), plot.y(value), plot.x(span.end), plot.y(value), "limit");
}

void draw_limit(SvgCanvas& canvas, const Plot& plot, const PanelContent& content) {
    if (!content.limit) return;
    if (!content.limit->spans.empty()) {
        for (const LimitSpan& span : content.limit->spans) draw_level(canvas, plot, span);
        canvas.text(plot.frame.left + 6, plot.frame.top + 14, content.limit->words, "limit-label");
        return;
    }
    const double value = content.limit->normalised;
    if (value > plot.upper) {
        canvas.text(plot.right() - 6, plot.frame.top + 14, fmt::format("{} lies above", content.limit->words),
                    "limit-label end");
        return;
    }
    canvas.line(plot.frame.left, plot.y(value), plot.right(), plot.y(value), "limit");
    if (-value >= plot.lower)
        canvas.line(plot.frame.left, plot.y(-value), plot.right(), plot.y(-value), "limit");
    // The label goes to the end of the line that is farther from the peak.
    const bool peak_left = !content.peaks.empty() &&
                           plot.x(content.peaks.front().where.at) < plot.frame.left + 0.5 * plot.frame.width;
    if (peak_left)
        canvas.text(plot.right() - 6, plot.y(value) - 6, content.limit->words, "limit-label end");
    else
        canvas.text(plot.frame.left + 6, plot.y(value) - 6, content.limit->words, "limit-label");
}

void draw_peak(SvgCanvas& canvas, const Plot& plot, const PanelContent& content, const PanelPeak& peak) {
    const double x = plot.x(peak.where.at), y = plot.y(peak.where.value);
    canvas.circle(x, y, 4, "peak");
    const bool left = x<plot.frame.left + edge, right = x> plot.right() - edge;
    const double label_x = left    ? std::max(x, plot.frame.left + 8)
                           : right ? std::min(x, plot.right() - 8)
                                   : x;
    const char* const anchor = left ? "peak-label" : right ? "peak-label end" : "peak-label middle";
    // Under a limit line that is close above, the label goes below the curve.
    const bool limit_close = content.limit && plot.y(content.limit->normalised) < y - 3 &&
                             plot.y(content.limit->normalised) > y - 26;
    const bool above = peak.where.value >= 0.0 && !limit_close;
    canvas.text(label_x, above ? y - 9 : y + 19, peak.words, anchor);
}

/// A set point as an open square, a region as a thick line between two of them.
void draw_marks(SvgCanvas& canvas, const Plot& plot, const PanelContent& content) {
    constexpr double half = 4.0;
    for (const PanelMark& mark : content.marks) {
        const double y = plot.y(mark.value);
        if (mark.end > mark.x) canvas.line(plot.x(mark.x), y, plot.x(mark.end), y, "set-region");
        for (const double x : {mark.x, mark.end})
            canvas.rectangle(plot.x(x) - half, y - half, 2.0 * half, 2.0 * half, "set-point");
    }
}

}  // namespace

std::string_view panel_style() {
    return ".unit,.compare{fill:#555}.axis{stroke:#8a8a8a;stroke-width:1}"
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
           ".peak{fill:#0072b2;stroke:#fff;stroke-width:1.5}"
           ".peak-label{font-weight:600;fill:#005a8c;paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-"
           "linejoin:round}";
}

void draw_panel(SvgCanvas& canvas, const PanelFrame& frame, const PanelContent& content) {
    const Plot plot = make_plot(frame, content);
    const PlotMap map{[&](double x) { return plot.x(x); }, [&](double value) { return plot.y(value); }};
    draw_angle_axis(canvas, plot, content);
    draw_segments(canvas, plot, content);
    draw_value_axes(canvas, plot, content);
    canvas.rectangle(frame.left, frame.top, frame.width, frame.height, "frame");
    if (content.measured) canvas.path(curve_path(*content.measured, content.order, map), "measured");
    if (content.reference) canvas.path(curve_path(*content.reference, content.order, map), "reference");
    canvas.path(curve_path(*content.optimum, content.order, map), "optimum");
    draw_marks(canvas, plot, content);
    draw_limit(canvas, plot, content);
    for (const PanelPeak& peak : content.peaks) draw_peak(canvas, plot, content, peak);
    // Both captions in a line where they fit.
    const double words =
        text_width(content.caption, caption_font, true) + text_width(content.caption_right, compare_font);
    const bool both = words + 12.0 < frame.width;
    canvas.text(frame.left, both ? frame.top - 8 : frame.top - 24, content.caption, "caption");
    canvas.text(plot.right(), frame.top - 8, content.caption_right, "compare end");
}

}  // namespace camopt
