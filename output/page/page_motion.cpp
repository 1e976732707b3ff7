// SPDX-License-Identifier: MIT
// Displacement, velocity, acceleration and jerk by the cam angle, with limits, peaks and exact points.
#include "output/chart/limit_spans.hpp"
#include "output/chart/reference_motion.hpp"
#include "output/page/page_parts.hpp"
#include "output/words/motion_extremes.hpp"
#include "scene/motion/set_points.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace camopt {

namespace {

constexpr int mark_digits = 6;  // as in the tables
constexpr std::array<const char*, 4> motion_keys = {"displacement", "velocity", "acceleration", "jerk"};
constexpr std::array<const char*, 4> motion_titles = {"Displacement", "Velocity", "Acceleration", "Jerk"};

/// One derivative of the solution's motion.
struct MotionCurve {
    const Solution& solution;
    const PageRows& rows;
    const ShownUnits& units;
    int order = 0;

    [[nodiscard]] const ShownDerivative& shown() const {
        return units.motion[static_cast<std::size_t>(order)];
    }
    [[nodiscard]] Json value(double normalised) const {
        return rounded_json(shown().first.per_normalised * normalised);
    }
    [[nodiscard]] Json angle(double x) const { return rounded_json(units.degrees_per_x * x); }
};

Json values_of(const MotionCurve& curve) {
    Json values = Json::array();
    for (std::size_t i = 0; i < curve.rows.rows.size(); ++i)
        values.push_back(curve.value(
            page_motion_at(curve.solution, curve.rows, i).derivative[static_cast<std::size_t>(curve.order)]));
    return values;
}

/// Another motion beside it, by the same rows: null where there is none.
Json values_beside(const MotionCurve& curve, const Motion* motion, const std::string& title) {
    if (motion == nullptr) return nullptr;
    return {{"title", title}, {"values", values_along(*motion, curve.rows, curve.shown().first)}};
}

Json limits_of(const MotionCurve& curve) {
    Json all = Json::array();
    if (curve.order == 0) return all;
    const std::optional<PeakLimit>& limit = peak_limit_of(curve.solution.scene.limits, curve.order);
    if (!limit) return all;
    std::vector<LimitSpan> spans = segment_limits(curve.solution, *limit, curve.order);
    const Motion& motion = *curve.solution.motion;
    if (spans.empty()) spans.push_back({motion.begin(), motion.end(), limit->normalised});
    const std::string words =
        fmt::format("limit {}{}{}", short_text(limit->given), limit->unit.empty() ? "" : " ", limit->unit);
    for (const LimitSpan& span : spans)
        for (const int side : {1, -1})
            all.push_back({{"from", curve.angle(span.begin)},
                           {"to", curve.angle(span.end)},
                           {"at", curve.value(side * span.normalised)},
                           {"outside", side},
                           {"words", words}});
    return all;
}

Json mark_of(const MotionCurve& curve, const Extremum& peak) {
    return {{"at", curve.angle(peak.at)},
            {"value", curve.value(peak.value)},
            {"words", curve.shown().first.normalised_text(peak.value, mark_digits)},
            {"given", false}};
}

/// The peaks of both signs; of the displacement where it leaves the range of its stroke.
Json peak_marks(const MotionCurve& curve) {
    Json all = Json::array();
    if (curve.order == 0) {
        for (const Excursion& one : excursions(curve.solution)) all.push_back(mark_of(curve, one.farthest));
        return all;
    }
    const SignedPeaks peaks = signed_peaks(curve.solution, curve.order);
    if (std::isfinite(peaks.largest.value)) all.push_back(mark_of(curve, peaks.largest));
    if (peaks.opposite) all.push_back(mark_of(curve, *peaks.opposite));
    return all;
}

/// The exact points that the scene demands, on the curve of what they demand; of a region, which is run
/// through at a constant velocity, with its end as "to".
void add_given_points(Json& curves, const Solution& solution, const ShownUnits& units) {
    for (const PlacedPoint& point : placed_points(solution.scene.motion)) {
        for (std::size_t order = 0; order < point.wanted.size(); ++order) {
            if (!point.wanted[order]) continue;
            const MotionUnit& unit = units.motion[order].first;
            Json mark = {{"at", rounded_json(units.degrees_per_x * point.begin)},
                         {"value", rounded_json(unit.per_normalised * *point.wanted[order])},
                         {"words", "given: " + unit.normalised_text(*point.wanted[order], mark_digits)},
                         {"given", true}};
            if (point.is_region() && order == 1) mark["to"] = rounded_json(units.degrees_per_x * point.end);
            curves[order]["marks"].push_back(std::move(mark));
        }
    }
}

}  // namespace

Json values_along(const Motion& motion, const PageRows& rows, const MotionUnit& unit) {
    Json values = Json::array();
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
        const MotionRow& row = rows.rows[i];
        const bool inside = i < rows.own && row.x >= motion.begin() && row.x <= motion.end();
        values.push_back(
            inside ? rounded_json(unit.per_normalised * motion.at(row.x, row.side).derivative[unit.order])
                   : Json(nullptr));
    }
    return values;
}

Json motion_curves(const Solution& solution, const PageRows& rows) {
    Json all = Json::array();
    if (!solution.motion) return all;
    const ShownUnits units = shown_units(solution.scene);
    const ReferenceMotion reference = reference_motion(solution.scene);
    const Motion* const measured = solution.measured ? solution.measured->motion.get() : nullptr;
    for (int order = 0; order < 4; ++order) {
        const auto index = static_cast<std::size_t>(order);
        const MotionCurve curve{solution, rows, units, order};
        const ShownDerivative& shown = curve.shown();
        Json beside = nullptr;
        if (shown.beside)
            beside = {{"unit", shown.beside->name},
                      {"symbol", shown.beside->symbol},
                      {"factor", rounded_json(shown.beside->per_normalised / shown.first.per_normalised)}};
        all.push_back({{"key", motion_keys[index]},
                       {"group", "motion"},
                       {"title", motion_titles[index]},
                       {"symbol", shown.first.symbol},
                       {"unit", shown.first.name},
                       {"beside", std::move(beside)},
                       {"values", values_of(curve)},
                       {"reference", values_beside(curve, reference.motion.get(), reference.title)},
                       {"measured", values_beside(curve, measured, "measured")},
                       {"limits", limits_of(curve)},
                       {"marks", peak_marks(curve)}});
    }
    add_given_points(all, solution, units);
    return all;
}

}  // namespace camopt
