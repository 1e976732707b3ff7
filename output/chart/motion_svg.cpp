// SPDX-License-Identifier: MIT
#include "output/chart/motion_svg.hpp"

#include "core/errors.hpp"
#include "output/chart/axis_ticks.hpp"
#include "output/chart/limit_spans.hpp"
#include "output/chart/motion_panel.hpp"
#include "output/chart/placed_texts.hpp"
#include "output/chart/svg_canvas.hpp"
#include "output/words/number_text.hpp"
#include "output/words/shown_units.hpp"
#include "output/words/solution_text.hpp"
#include "output/words/tables/peak_comparison.hpp"
#include "output/words/tables/segment_table.hpp"
#include "scene/limit_table.hpp"
#include "scene/motion/set_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt {

namespace {

// Layout, px.
constexpr double page_width = 1000, panel_left = 92, panel_width = 832, first_panel = 142, panel_height = 178,
                 panel_distance = 218, page_height = first_panel + 3 * panel_distance + panel_height + 56;

const char* page_style =
    ".page{fill:#fff}.title{font-size:20px;font-weight:600}.subtitle{font-size:13px;fill:#333}";

struct Picture {
    const Solution& solution;
    ReferenceMotion reference;
    ShownUnits shown;
    std::vector<PeakRow> peaks;
};

std::optional<PanelLimit> panel_limit(const Picture& picture, int order) {
    const std::optional<PeakLimit>& limit = peak_limit_of(picture.solution.scene.limits, order);
    if (!limit) return {};
    PanelLimit shown{
        limit->normalised,
        fmt::format("limit {}{}{}", short_text(limit->given), limit->unit.empty() ? "" : " ", limit->unit),
        {}};
    shown.spans = segment_limits(picture.solution, *limit, order);
    if (shown.spans.empty()) return shown;
    shown.normalised = std::ranges::max(shown.spans, {}, &LimitSpan::normalised).normalised;
    shown.words += " by the segment's own angle and displacement";
    return shown;
}

/// For a program the mark is at the peak of the motion itself; the normalised peak, of some spline segment,
/// stands in the caption.
std::string peak_words(PanelContent& content, const Picture& picture, const PeakRow& row) {
    const std::string physical = row.first_text(), beside = row.beside_text();
    const std::string normalised = fmt::format("{} = {}", row.symbol, short_text(row.optimum.value));
    const bool program = !picture.solution.segments.empty();
    if (!program && !beside.empty()) content.caption += fmt::format(" (peak {})", beside);
    if (program) content.caption_right = normalised + " of the spline segments";
    if (row.reference)
        content.caption_right += fmt::format(
            "{}{} {} = {} · change {}", program ? " · " : "", reference_title(picture.reference), row.symbol,
            short_text(*row.reference), change_text(row.optimum.value, *row.reference));
    if (program) return beside.empty() ? physical : fmt::format("{} ({})", physical, beside);
    return picture.shown.in_time ? physical + " · " + normalised : normalised + " · " + physical;
}

void add_peaks(PanelContent& content, const Picture& picture) {
    const PeakRow& row = picture.peaks[static_cast<std::size_t>(content.order) - 1];
    const std::string words = peak_words(content, picture, row);
    if (std::isfinite(row.sides.largest.value)) content.peaks.push_back({row.sides.largest, words});
    if (row.sides.opposite) content.peaks.push_back({*row.sides.opposite, row.opposite_text()});
    content.limit = panel_limit(picture, content.order);
}

std::vector<PanelSegment> panel_segments(const Solution& solution, bool titles) {
    std::vector<PanelSegment> all;
    for (const SegmentReport& segment : solution.segments)
        all.push_back({segment.begin, segment.end, titles ? segment_title(segment) : ""});
    return all;
}

std::vector<PanelMark> panel_marks(const Solution& solution, std::size_t order) {
    std::vector<PanelMark> marks;
    for (const PlacedPoint& point : placed_points(solution.scene.motion)) {
        if (!point.wanted[order]) continue;
        marks.push_back({point.begin, order == 1 ? point.end : point.begin, *point.wanted[order]});
    }
    return marks;
}

PanelContent panel_content(const Picture& picture, int order) {
    static constexpr std::array<const char*, 4> captions = {"Displacement", "Velocity", "Acceleration",
                                                            "Jerk"};
    const auto index = static_cast<std::size_t>(order);
    PanelContent content;
    content.order = order;
    content.optimum = picture.solution.motion.get();
    content.reference = picture.reference.motion.get();
    if (picture.solution.measured) content.measured = picture.solution.measured->motion.get();
    if (order < 3) content.marks = panel_marks(picture.solution, index);
    const MotionUnit& unit = picture.shown.motion[index].first;
    content.caption = fmt::format("{} {}", captions[index], unit.symbol);
    content.factor = unit.per_normalised;
    content.unit = unit.name;
    content.degrees_per_x = picture.shown.degrees_per_x;
    content.angle_ticks = degree_ticks(0.0, content.degrees_per_x * content.optimum->end(), 14);
    content.angle_labels = order == 3;
    content.segments = panel_segments(picture.solution, order == 0);
    if (order > 0) {
        add_peaks(content, picture);
    } else {
        for (const Excursion& one : excursions(picture.solution))
            content.peaks.push_back({one.farthest, unit.normalised_text(one.farthest.value)});
        content.caption_right =
            fmt::format("left axis: physical units · right axis: normalised by lift and {}",
                        picture.solution.segments.empty() ? "rise" : "the angle of the first spline segment");
    }
    return content;
}

void draw_legend(SvgCanvas& canvas, const Picture& picture) {
    double x = panel_left;
    const double y = first_panel - 38;
    const auto entry = [&](const char* css_class, const std::string& words) {
        canvas.line(x, y - 4, x + 30, y - 4, css_class);
        canvas.text(x + 37, y, words, "subtitle");
        x += 37 + 7.2 * static_cast<double>(words.size()) + 26;
    };
    entry("optimum", "this motion");
    if (picture.reference.motion) entry("reference", picture.reference.title);
    if (picture.solution.measured) entry("measured", "measured");
    const LimitSpec& limits = picture.solution.scene.limits;
    if (std::ranges::any_of(peak_limit_rows(),
                            [&](const PeakLimitRow& row) { return row.in(limits).has_value(); }))
        entry("limit", "limit");
    canvas.circle(x + 4, y - 4, 4, "peak");
    canvas.text(x + 15, y, "peaks", "subtitle");
    x += 76;
    if (!placed_points(picture.solution.scene.motion).empty()) {
        canvas.rectangle(x, y - 8, 8, 8, "set-point");
        canvas.text(x + 15, y, "set points", "subtitle");
        x += 96;
    }
    if (!picture.solution.segments.empty()) {
        canvas.line(x, y - 11, x, y + 3, "segment");
        canvas.text(x + 8, y, "segments", "subtitle");
        x += 92;
    }
    canvas.line(x, y - 7, x, y - 1, "breakpoint");
    canvas.text(x + 8, y, fmt::format("breakpoints ({})", picture.solution.motion->breakpoints().size()),
                "subtitle");
}

/// In two lines where it is too long for one.
void draw_objective(SvgCanvas& canvas, const std::string& words) {
    constexpr std::string_view dot = " · ";
    constexpr double first = 76, second = 91, font = 13, room = page_width - panel_left - 8;
    std::size_t end = words.size();
    while (end != std::string::npos && end > 0 && text_width(words.substr(0, end), font) > room)
        end = words.rfind(dot, end - 1);
    if (end == 0 || end == std::string::npos) end = words.size();
    canvas.text(panel_left, first, words.substr(0, end), "subtitle");
    if (end < words.size()) canvas.text(panel_left, second, words.substr(end + dot.size()), "subtitle");
}

}  // namespace

std::string motion_svg(const Solution& solution) {
    if (!solution.motion) throw InputError("motion.svg needs a motion, and this solution has none");
    ReferenceMotion reference = reference_motion(solution.scene);
    std::vector<PeakRow> peaks = peak_comparison(solution, reference);
    const Picture picture{solution, std::move(reference), shown_units(solution.scene), std::move(peaks)};

    const std::string title = solution.scene.title.empty() ? "Motion" : solution.scene.title;
    SvgCanvas canvas(page_width, page_height, std::string(panel_style()) + page_style, title);
    canvas.rectangle(0, 0, page_width, page_height, "page");
    canvas.text(panel_left, 36, title, "title");
    canvas.text(panel_left, 58, verdict_sentence(solution), "subtitle");
    draw_objective(canvas, objective_line(solution, " · "));
    draw_legend(canvas, picture);
    for (int order = 0; order < 4; ++order) {
        const PanelFrame frame{panel_left, first_panel + order * panel_distance, panel_width, panel_height};
        draw_panel(canvas, frame, panel_content(picture, order));
    }
    canvas.text(panel_left + 0.5 * panel_width, page_height - 16, "cam angle θ (deg)", "unit middle");
    return canvas.finish();
}

}  // namespace camopt
