// SPDX-License-Identifier: MIT
#include "report/chart/curve_chart.hpp"

#include "report/chart/chart.hpp"
#include "report/view/verdict_words.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr double panel_width = 812, panel_height = 196;  // px
constexpr double headroom = 0.17;                        // of the range, above and below: for the labels
constexpr double limit_in_sight = 2.0;  // a limit beyond this many times the largest value is not drawn
constexpr double below_zero = 0.02;     // of the largest value: less than this is no negative value
constexpr std::size_t most_breakpoints = 200;  // more would be a grey band
constexpr int angle_digits_of_mark = 5;        // as in the report
constexpr double bold_label_font = 13;         // px: as wide as 12 in bold

PlotAxis value_axis(const Curve& curve) {
    ValueRange range;
    range.add(0.0);
    for (const double value : curve.values) range.add(value);
    for (const CurveMark& mark : curve.marks) range.add(mark.value);
    for (const auto& [at, value] : curve.points) range.add(value);
    for (const auto* other : {&curve.reference, &curve.measured})
        if (*other)
            for (const double value : (*other)->values) range.add(value);
    if (curve.band)
        for (const auto* edge : {&curve.band->low, &curve.band->high})
            for (const double value : *edge) range.add(value);
    const double size = std::max(range.upper, -range.lower);
    const bool falls = range.lower<-below_zero * size, rises = range.upper> below_zero * size;
    for (const CurveLimit& limit : curve.limits)
        if (std::abs(limit.at) <= limit_in_sight * size && (limit.at > 0.0 ? rises : falls))
            range.add(limit.at);
    const double width = range.upper > range.lower ? range.upper - range.lower : 1.0;
    return {range.lower - headroom * width, range.upper + headroom * width};
}

/// A set point as an open square, a region as a thick line between two of them; extremes with their labels.
void add_marks(ChartPanel& panel, const Curve& curve) {
    ChartSeries peaks{Look::dot, "peak", {}, 4.0, "peaks", "peak-label", LabelSide::above, bold_label_font},
        lows = peaks, squares{Look::square, "set-point", {}, 4.0, "set points"};
    lows.side = LabelSide::below;
    for (const CurveMark& mark : curve.marks) {
        if (mark.given) {
            squares.points.push_back({mark.at, mark.value});
            if (!mark.to) continue;
            squares.points.push_back({*mark.to, mark.value});
            panel.series.push_back(
                {Look::line, "set-region", {{mark.at, mark.value}, {*mark.to, mark.value}}});
        } else if (mark.value != 0.0) {
            (mark.value > 0.0 ? peaks : lows)
                .points.push_back(
                    {mark.at, mark.value, "",
                     fmt::format("{} at {}°", mark.words, short_text(mark.at, angle_digits_of_mark))});
        }
    }
    if (!squares.points.empty()) panel.series.push_back(std::move(squares));
    panel.series.push_back(std::move(peaks));
    panel.series.push_back(std::move(lows));
}

void add_limits(ChartPanel& panel, const Curve& curve) {
    ChartSeries outside{Look::label, "", {}, 4.0, "", "limit-label", LabelSide::below};
    for (const CurveLimit& limit : curve.limits) {
        if (panel.frame.vertical.holds(limit.at))
            panel.series.push_back({Look::line,
                                    "limit",
                                    {{limit.from, limit.at, "", limit.words}, {limit.to, limit.at}},
                                    4.0,
                                    "limit",
                                    "limit-label",
                                    limit.at > 0.0 ? LabelSide::above : LabelSide::below});
        else if (limit.at > 0.0 && outside.points.empty())  // of two lines of one limit one is named
            outside.points.push_back({panel.frame.horizontal.upper, panel.frame.vertical.upper, "",
                                      limit.words + " lies outside"});
    }
    panel.series.push_back(std::move(outside));
}

/// Ticks at the breakpoints, rules at the bounds of segments; the titles of these only in the first panel.
void add_bounds(ChartPanel& panel, const CurveSet& set, bool first) {
    const double low = panel.frame.vertical.lower;
    ChartSeries rules{Look::rule, "segment", {}, 7.0, set.segments.empty() ? "" : "segments"},
        ticks{Look::tick, "breakpoint", {}, 2.5, fmt::format("breakpoints ({})", set.breakpoints.size())};
    const PlotAxis across{panel.frame.horizontal.lower, panel.frame.horizontal.upper, 0.0, panel_width};
    for (const auto& [from, to, title] : set.segments) {
        if (from > across.lower) rules.points.push_back({from, low});
        if (first && text_width(title, 12.0) < across.place(to) - across.place(from))
            panel.series.push_back({Look::line,
                                    "",
                                    {{from, low, "", title}, {to, low}},
                                    4.0,
                                    "",
                                    "segment-label",
                                    LabelSide::above});
    }
    if (set.breakpoints.size() <= most_breakpoints)
        for (const double at : set.breakpoints) ticks.points.push_back({at, low});
    panel.series.push_back(std::move(rules));
    panel.series.push_back(std::move(ticks));
}

/// A closed line around each stretch that has values.
void add_band(ChartPanel& panel, const CurveSet& set, const CurveBand& band, std::size_t rows) {
    ChartSeries around{Look::line, "made", {}, 4.0, "made cams"};
    std::size_t begin = 0;
    const auto close = [&](std::size_t end) {
        if (end - begin > 1) {
            for (std::size_t i = begin; i < end; ++i) around.points.push_back({set.angles[i], band.high[i]});
            for (std::size_t i = end; i > begin; --i)
                around.points.push_back({set.angles[i - 1], band.low[i - 1]});
            around.points.push_back(around.points.front());
            panel.series.push_back(around);
        }
        around.points.clear();
        begin = end + 1;
    };
    for (std::size_t i = 0; i < rows; ++i)
        if (!std::isfinite(band.low[i]) || !std::isfinite(band.high[i])) close(i);
    close(rows);
}

ChartPanel panel_of(const CurveSet& set, const Curve& curve, std::size_t rows, bool first,
                    const std::string& line_title = "this motion") {
    ChartPanel panel;
    panel.width = panel_width;
    panel.height = panel_height;
    panel.caption = fmt::format("{} ({})", curve.title, curve.symbol);
    panel.note = curve.note;
    panel.warning = !std::ranges::all_of(curve.values, [](double value) { return std::isfinite(value); });
    if (panel.warning && panel.note.empty()) panel.note = "it leaves the frame";
    panel.frame.horizontal = {set.angles.front(), set.angles[rows - 1]};
    panel.frame.vertical = value_axis(curve);
    panel.frame.vertical_title = curve.unit.name;
    panel.beside_factor = curve.normalised_factor;
    const auto add_line = [&](const std::vector<double>& values, const char* css, const std::string& title) {
        ChartSeries line{Look::line, css, {}, 4.0, title};
        for (std::size_t i = 0; i < rows; ++i) line.points.push_back({set.angles[i], values[i]});
        panel.series.push_back(std::move(line));
    };
    if (curve.band) add_band(panel, set, *curve.band, rows);
    if (curve.measured) add_line(curve.measured->values, "measured", curve.measured->title);
    if (curve.reference) add_line(curve.reference->values, "reference", curve.reference->title);
    ChartSeries table{Look::dot, "measured-point", {}, 1.4, "rows of the table"};
    for (const auto& [at, value] : curve.points) table.points.push_back({at, value});
    if (curve.key == "residual")
        panel.series.push_back({Look::line, "measured", table.points, 4.0, "measured"});
    else
        add_line(curve.values, "optimum", line_title);
    if (!table.points.empty()) panel.series.push_back(std::move(table));
    add_bounds(panel, set, first);  // before the marks: a segment's name has its place within the segment
    add_marks(panel, curve);
    add_limits(panel, curve);
    return panel;
}

/// Round degrees; their numbers where the axis has a title.
void add_angle_axis(ChartPanel& panel, std::string title) {
    for (const double tick : degree_ticks(panel.frame.horizontal.lower, panel.frame.horizontal.upper, 13))
        panel.frame.horizontal_ticks.push_back({tick, title.empty() ? "" : tick_text(tick, 1.0)});
    panel.frame.horizontal_title = std::move(title);
}

/// The lowest panel carries the numbers of the cam angle. The diagrams of a cam go over all of it and have no
/// legend; those of the motion go over the motion.
Chart chart_of(const View& view, std::string title, const std::vector<const Curve*>& curves, bool motion) {
    Chart chart{std::move(title)};
    const std::vector<DeliveredRow>& all = view.delivered.rows;
    const auto closing = std::ranges::find(all, true, &DeliveredRow::closing);
    const std::size_t rows = motion ? static_cast<std::size_t>(closing - all.begin()) : all.size();
    for (const Curve* curve : curves) {
        ChartPanel& panel = chart.panels.emplace_back(panel_of(view, *curve, rows, curve == curves.front()));
        add_angle_axis(panel, curve == curves.back() ? "cam angle θ (deg)" : "");
        for (ChartSeries& series : panel.series)
            if (!motion) series.title.clear();
    }
    return chart;
}

/// The curves of a group ("motion", "cam", "forces") whose keys begin with `key`; in their order.
std::vector<const Curve*> curves_of(const View& view, std::string_view group, std::string_view key = {}) {
    std::vector<const Curve*> found;
    for (const Curve& curve : view.curves)
        if (curve.group == group && curve.key.starts_with(key)) found.push_back(&curve);
    return found;
}

/// Both signs of torque and speed: the motor drives and brakes.
ChartPanel torque_over_speed(const View& view) {
    const std::vector<const Curve*> curves = curves_of(view, "motor");
    const Curve &torque = *curves[0], &speed = *curves[1];
    ChartPanel panel;
    panel.width = panel_width;
    panel.height = 1.6 * panel_height;
    panel.caption = "Torque over speed";
    panel.frame.horizontal_title = "speed of the motor (rpm)";
    panel.frame.vertical_title = torque.unit.name;
    const auto path = [&](const std::vector<double>& n, const std::vector<double>& values, const char* css) {
        ChartSeries line{Look::line, css};
        for (std::size_t i = 0; i < n.size(); ++i) line.points.push_back({n[i], values[i]});
        panel.series.push_back(std::move(line));
    };
    if (torque.reference) path(speed.reference->values, torque.reference->values, "reference");
    path(speed.values, torque.values, "optimum");
    const LimitSpec& limits = view.solution.scene.limits;
    const MotorCurve& curve = limits.motor_curve;
    const auto [least, most] = std::ranges::minmax(speed.values);
    const bool reverses = least < -1e-6 * most;
    const auto limit_line = [&](std::vector<ChartPoint> points) {
        panel.series.push_back(
            {Look::line, "limit", std::move(points), 4.0, "", "limit-label", LabelSide::below});
    };
    for (const int side : {1, -1}) {
        if (const auto& limit = limits.motor_torque; limit && curve.empty()) {
            const double at = side * torque.unit.of(limit->value);
            limit_line({{least, at, {}, "limit " + torque.unit.text(side * limit->value)}, {most, at}});
        }
        std::vector<ChartPoint> polygon;
        for (auto point = curve.rbegin(); reverses && point != curve.rend(); ++point)
            polygon.push_back({-rpm_shown.of((*point)[0]), side * torque.unit.of((*point)[1])});
        for (const auto& [n, value] : curve)
            polygon.push_back({rpm_shown.of(n), side * torque.unit.of(value)});
        if (polygon.empty()) continue;
        polygon.front().label = "curve of the motor";
        limit_line(std::move(polygon));
    }
    return panel;
}

}  // namespace

std::string motion_svg(const View& view) {
    if (!view.solution.motion) throw InputError("motion.svg needs a motion, and this solution has none");
    Chart chart = chart_of(view, view.title("Motion"), curves_of(view, "motion"), true);
    chart.lines = {
        verdict_sentence(view.solution), objective_line(view.solution, " · "),
        fmt::format("Left axis: physical units. Right axis: normalised by lift and {}.",
                    view.segments.empty()                     ? "rise"
                    : view.solution.scene.motion.prescribed() ? "the angle of the first law"
                                                              : "the angle of the first spline segment")};
    return chart_svg(std::move(chart));
}

std::string curve_set_svg(const CurveSet& set, const CurvePicture& picture) {
    Chart chart{picture.title, picture.lines};
    for (const Curve& curve : set.curves) {
        ChartPanel& panel = chart.panels.emplace_back(
            panel_of(set, curve, set.angles.size(), &curve == &set.curves.front(), picture.line_title));
        add_angle_axis(panel, &curve == &set.curves.back() ? picture.angle_title : "");
        // The labels of marks say what they are.
        for (ChartSeries& series : panel.series)
            if (series.points.empty() || series.css == "peak") series.title.clear();
    }
    return chart_svg(std::move(chart));
}

std::string cam_diagrams_svg(const View& view, std::string_view key) {
    return chart_svg(chart_of(view, view.title("Cam"), curves_of(view, "cam", key), false));
}

std::string force_diagrams_svg(const View& view) {
    const std::vector<const Curve*> curves = curves_of(view, "forces");
    if (curves.empty()) throw InputError("forces.svg needs forces, and this solution has none");
    const std::string& title = view.solution.scene.title;
    return chart_svg(chart_of(view, title.empty() ? "Forces" : title + ": forces", curves, false));
}

std::string drive_svg(const View& view) {
    const std::string& title = view.solution.scene.title;
    Chart chart = chart_of(view, title.empty() ? "Motor" : title + ": motor", curves_of(view, "motor"), true);
    chart.panels.push_back(torque_over_speed(view));
    return chart_svg(std::move(chart));
}

std::string torque_over_speed_svg(const View& view) {
    return chart_svg({"", {}, {torque_over_speed(view)}});
}

std::string surge_svg(const View& view) {
    const SurgeReport& surge = *view.solution.surge;
    const ShownUnit& unit = view.units.vibration;
    ChartPanel panel{.width = panel_width, .height = 1.6 * panel_height};
    panel.frame.horizontal_title = "harmonic of the speed of the cam";
    panel.frame.vertical_title = fmt::format("amplitude ({})", unit.name);
    panel.frame.vertical.logarithmic = true;
    ChartSeries others{Look::dot, "measured-point", {}, 3.5, "harmonics of the lift"},
        near{Look::dot, "peak", {}, 4.5, "those near the spring's frequency"},
        limit{Look::line, "limit", {}, 4.0, "", "limit-label", LabelSide::above};
    const auto& written = view.solution.scene.limits.spring_harmonic;
    const double nothing = 1e-9 * view.solution.scene.motion.lift;  // it would stretch the axis
    for (const SurgeReport::Harmonic& one : surge.harmonics) {
        if (one.amplitude > nothing)
            (one.near ? near : others).points.push_back({1.0 * one.order, unit.of(one.amplitude)});
        for (const double end : {-0.5, 0.5})
            if (one.limited) limit.points.push_back({one.order + end, unit.of(written->value)});
    }
    if (!limit.points.empty()) limit.points.front().label = "limit " + unit.text(written->value);
    const double height = near.points.empty() ? 1.0 : near.points.front().y;
    ChartSeries spring{
        Look::rule, "segment", {{surge.frequency_ratio, height}}, 4.0, "natural frequency of the spring"};
    panel.series = {std::move(spring), std::move(others), std::move(near), std::move(limit)};
    const std::string& title = view.solution.scene.title;
    return chart_svg({title.empty() ? "Spring surge" : title + ": spring surge", {}, {std::move(panel)}});
}

}  // namespace camopt
