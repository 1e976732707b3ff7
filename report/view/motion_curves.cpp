// SPDX-License-Identifier: MIT
// Displacement, velocity, acceleration and jerk by the cam angle, with limits, peaks and set points.
#include "objectives/motion_bounds.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "report/view/peak_comparison.hpp"
#include "report/view/view.hpp"
#include "scene/limit_table.hpp"
#include "scene/motion/set_points.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr std::size_t most_points = 2000;  // in pictures and pages
constexpr double beyond_end = 1e-9;        // x: a row beyond the end by less is rounding of an angle
constexpr std::array<const char*, 4> titles = {"Displacement", "Velocity", "Acceleration", "Jerk"};

/// Limits of one side and corridors.
std::vector<CurveLimit> bounds_of(const View& view, const MotionUnit& unit) {
    std::vector<CurveLimit> all;
    const Scene& scene = view.solution.scene;
    const Motion& motion = view.solution.output_motion();
    for (const WrittenBound& bound : motion_bounds(scene)) {
        if (bound.of_motor() || bound.order != static_cast<int>(unit.order)) continue;
        all.push_back(
            {view.degrees(std::max(bound.from, motion.begin())),
             view.degrees(std::min(bound.until, motion.end())),
             unit.per_normalised * bound.sign * bound.bound, bound.sign,
             fmt::format("{}limit {}{}{}", bound.seen == SeenMotion::cam ? "the cam's " : "",
                         short_text(bound.given), bound.unit.empty() ? "" : " ", unit_words(bound.unit))});
    }
    return all;
}

std::vector<CurveLimit> limits_of(const View& view, const MotionUnit& unit) {
    std::vector<CurveLimit> all = bounds_of(view, unit);
    if (unit.order == 0) return all;
    const int order = static_cast<int>(unit.order);
    const std::optional<PeakLimit>& limit = peak_limit_of(view.solution.scene.limits, order);
    if (!limit) return all;
    std::vector<LimitSpan> spans = segment_limits(view.solution, *limit, order);
    const Motion& motion = view.solution.output_motion();
    const bool by_segment = !spans.empty();
    if (!by_segment) spans.push_back({motion.begin(), motion.end(), limit->normalised});
    const std::string words =
        fmt::format("limit {}{}{}{}", short_text(limit->given), limit->unit.empty() ? "" : " ", limit->unit,
                    by_segment ? " by the segment" : "");
    for (const LimitSpan& span : spans)
        for (const int side : {1, -1})
            all.push_back({view.degrees(span.begin), view.degrees(span.end),
                           unit.per_normalised * side * span.normalised, side, words});
    return all;
}

/// The peaks of both signs; of the displacement where it leaves the range of its stroke.
std::vector<CurveMark> peak_marks(const View& view, const MotionUnit& unit, const PeakRow* row) {
    std::vector<CurveMark> all;
    const auto add = [&](const Extremum& peak) {
        if (!std::isfinite(peak.value)) return;
        all.push_back({view.degrees(peak.at), unit.per_normalised * peak.value,
                       unit.normalised_text(peak.value, curve_mark_digits)});
    };
    if (row == nullptr) {
        for (const Excursion& one : excursions(view.solution)) add(one.farthest);
        return all;
    }
    add(row->sides.largest);
    if (row->sides.opposite) add(*row->sides.opposite);
    return all;
}

/// Set points on the curve of what they give; of a region, which has a constant velocity, with its end.
void add_set_points(std::vector<CurveMark>& marks, const View& view, const MotionUnit& unit) {
    for (const PlacedPoint& point : placed_points(view.solution.scene.motion)) {
        if (unit.order >= point.wanted.size() || !point.wanted[unit.order]) continue;
        const double value = *point.wanted[unit.order];
        CurveMark mark{view.degrees(point.begin), unit.per_normalised * value,
                       "given: " + unit.normalised_text(value, curve_mark_digits), true};
        if (point.is_region() && unit.order == 1) mark.to = view.degrees(point.end);
        marks.push_back(std::move(mark));
    }
}

std::string note_of(const View& view, const PeakRow& row, const ReferenceMotion& reference) {
    std::string note = fmt::format("{} = {}{}", row.symbol, short_text(row.optimum.value),
                                   view.segments.empty()                     ? ""
                                   : view.solution.scene.motion.prescribed() ? " of the laws"
                                                                             : " of the spline segments");
    if (row.reference)
        note += fmt::format(" · {} {} = {} · change {}", reference_title(reference), row.symbol,
                            short_text(*row.reference), row.change());
    return note;
}

/// The rows of the measured table on the motion, deg and in the unit of displacements.
std::vector<std::array<double, 2>> table_points(const View& view) {
    const Scene& scene = view.solution.scene;
    const MotionUnit& unit = view.units.motion[0].first;
    const Motion& fit = *view.solution.measured->motion;
    const double turn = scene.motion.unit_angle();
    std::vector<std::array<double, 2>> points;
    for (std::size_t k = 0; k < scene.measured->angle.size(); ++k) {
        const double x = scene.measured->angle[k] / turn;
        if (x < fit.begin() - beyond_end || x > fit.end() + beyond_end) continue;
        points.push_back(
            {view.degrees(x), unit.per_normalised * scene.measured->displacement[k] / scene.motion.lift});
    }
    return points;
}

std::vector<std::array<double, 2>> thinned(const std::vector<std::array<double, 2>>& points) {
    const std::size_t step = points.size() / most_points + 1;
    std::vector<std::array<double, 2>> some;
    for (std::size_t k = 0; k < points.size(); k += step) some.push_back(points[k]);
    return some;
}

/// At the rows of the view, linear from point to point; NaN beyond them.
std::vector<double> joined_points(const std::vector<std::array<double, 2>>& points, const View& view) {
    std::vector<double> values;
    std::size_t next = 0;
    for (std::size_t i = 0; i < view.angles.size(); ++i) {
        const double at = view.angles[i];
        while (next < points.size() && points[next][0] < at) ++next;
        const bool outside = view.delivered.rows[i].closing || next == points.size();
        if (!outside && points[next][0] == at) {
            values.push_back(points[next][1]);
        } else if (outside || next == 0) {
            values.push_back(std::nan(""));
        } else {
            const auto &before = points[next - 1], &after = points[next];
            const double part = (at - before[0]) / (after[0] - before[0]);
            values.push_back(before[1] + part * (after[1] - before[1]));
        }
    }
    return values;
}

/// Table − fit, the largest marked.
Curve residual_curve(const View& view) {
    const MeasuredReport& measured = *view.solution.measured;
    const MotionUnit& unit = view.units.motion[0].first;
    Curve curve{"residual", "motion", "Residual of the table", "table − fit",
                static_cast<const ShownUnit&>(unit)};
    std::vector<std::array<double, 2>> points = table_points(view);
    CurveMark largest;
    for (auto& [at, value] : points) {
        const double x = std::clamp((at - view.degrees(0.0)) / view.units.degrees_per_x,
                                    measured.motion->begin(), measured.motion->end());
        value -= unit.per_normalised * measured.motion->at(x).derivative[0];
        if (std::abs(value) > std::abs(largest.value)) largest = {at, value, {}};
    }
    curve.normalised_factor = 1.0 / unit.per_normalised;
    curve.values = joined_points(points, view);
    curve.points = thinned(points);
    if (largest.value != 0.0) {
        largest.words = curve.unit.text(largest.value * curve.unit.size, 3);
        curve.marks.push_back(largest);
    }
    curve.note = fmt::format("rms {} · {} rows, {} free numbers{}",
                             unit.normalised_text(measured.rms_error, 3), measured.rows, measured.freedom,
                             follows_noise(measured) ? ": the fit follows noise" : "");
    return curve;
}

constexpr double at_rest = 1e-9;  // of a displacement: less than this over a piece is a dwell

}  // namespace

std::shared_ptr<const Motion> reference_curve(const Solution& solution, ReferenceMotion& reference) {
    if (reference.motion || reference.title.empty()) return std::move(reference.motion);
    const auto is_spline = [](const ProgramSegment& one) { return one.kind == SegmentKind::spline; };
    if (std::ranges::none_of(solution.scene.motion.segments, is_spline)) return nullptr;
    return law_in_place(solution, solution.scene.objective.reference.law).motion;
}

std::vector<Curve> motion_curves(const View& view) {
    ReferenceMotion reference = reference_motion(view.solution.scene);
    const std::shared_ptr<const Motion> law = reference_curve(view.solution, reference);
    const std::vector<PeakRow> peaks = peak_comparison(view.solution, reference);
    const Motion* const measured = view.solution.measured ? view.solution.measured->motion.get() : nullptr;
    std::vector<Curve> all;
    for (std::size_t order = 0; order < titles.size(); ++order) {
        const ShownDerivative& shown = view.units.motion[order];
        const MotionUnit& unit = shown.first;
        const PeakRow* const row = order == 0 ? nullptr : &peaks[order - 1];
        Curve curve{shown.name, "motion", titles[order], unit.symbol, static_cast<const ShownUnit&>(unit)};
        for (const DeliveredRow& place : view.delivered.rows)
            curve.values.push_back(unit.per_normalised * place.output_motion().derivative[order]);
        if (view.solution.output) {
            curve.cam = ComparedCurve{"the cam", {}};
            for (const DeliveredRow& place : view.delivered.rows)
                curve.cam->values.push_back(unit.per_normalised * place.motion.derivative[order]);
        }
        curve.beside = shown.beside;
        if (shown.beside) curve.beside_factor = shown.beside->per_normalised / unit.per_normalised;
        curve.normalised_factor = 1.0 / unit.per_normalised;
        if (law != nullptr) curve.reference = ComparedCurve{reference.title, view.along(*law, unit)};
        if (measured != nullptr && !view.solution.measured->noise)  // of a given cam it is the motion itself
            curve.measured = ComparedCurve{"measured", view.along(*measured, unit)};
        if (measured != nullptr && order == 0) curve.points = thinned(table_points(view));
        curve.limits = limits_of(view, unit);
        curve.marks = peak_marks(view, unit, row);
        add_set_points(curve.marks, view, unit);
        if (row != nullptr) curve.note = note_of(view, *row, reference);
        all.push_back(std::move(curve));
    }
    // Lines and arcs are followed to rounding: there is no residual to look at.
    const std::optional<CamSpec>& cam = view.solution.scene.cam;
    if (measured != nullptr && !(cam && !cam->pieces.empty())) all.push_back(residual_curve(view));
    return all;
}

const std::optional<PeakLimit>& peak_limit_of(const LimitSpec& limits, int order) {
    static const std::optional<PeakLimit> none;
    for (const PeakLimitRow& row : peak_limit_rows())
        if (row.order() == order) return row.in(limits);
    return none;
}

/// A normalised limit holds for each spline segment by its own angle and displacement: the ratio of the
/// segment's two peaks is what brings it to the motion's own units.
std::vector<LimitSpan> segment_limits(const Solution& solution, const PeakLimit& limit, int order) {
    constexpr std::array peaks = {&Peaks::velocity, &Peaks::acceleration, &Peaks::jerk};
    const auto peak = peaks[static_cast<std::size_t>(order) - 1];
    std::vector<LimitSpan> spans;
    if (limit.physical()) return spans;
    for (const SegmentReport& segment : solution.segments) {
        if (!segment.curve || !segment.peaks) continue;
        const double normalised = ((*segment.peaks).*peak).value;
        if (!(normalised > 0.0)) continue;
        const double own = (peaks_of(*segment.curve).*peak).value;
        spans.push_back({segment.begin, segment.end, limit.normalised * own / normalised});
    }
    return spans;
}

std::vector<PressureLimit> pressure_spans(const Scene& scene, const Motion& motion) {
    const PressureLimits limits = pressure_limits(scene.limits);
    const std::optional<WrittenLimit> at_standstill = limits.at_rest();
    if (!at_standstill) return {};
    const double angle = scene.motion.unit_angle();
    std::vector<PressureLimit> spans;
    const std::vector<double> places = motion.breakpoints();
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const double change = motion.at(places[i + 1], Side::left).derivative[0] -
                              motion.at(places[i], Side::right).derivative[0];
        const auto& own = std::abs(change) < at_rest ? at_standstill
                          : change > 0.0             ? limits.rise
                                                     : limits.back;
        if (!own) continue;
        const bool goes_on =
            !spans.empty() && spans.back().end == angle * places[i] && spans.back().limit == own->value;
        if (goes_on)
            spans.back().end = angle * places[i + 1];
        else
            spans.push_back({angle * places[i], angle * places[i + 1], own->value});
    }
    return spans;
}

}  // namespace camopt
