// SPDX-License-Identifier: MIT
#include "output/page/page_data.hpp"

#include "core/version.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "objectives/scene_model.hpp"
#include "output/chart/limit_spans.hpp"
#include "output/page/page_html.hpp"
#include "output/page/page_parts.hpp"
#include "output/spatial/drum_pictures.hpp"
#include "output/words/cam_remarks.hpp"
#include "output/words/number_text.hpp"
#include "output/words/scene_words.hpp"
#include "output/words/tables/peak_comparison.hpp"
#include "output/words/tables/segment_table.hpp"
#include "scene/motion/set_points.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/compare/law_motion.hpp"
#include "studies/spatial/spatial_forward_check.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace camopt {

namespace {

constexpr int dwell_steps = 24;  // rows over the dwell that closes a cam

Json angle_part(const Solution& solution, const PageRows& rows) {
    const double degrees = shown_units(solution.scene).degrees_per_x;
    Json values = Json::array();
    for (const MotionRow& row : rows.rows) values.push_back(rounded_json(degrees * row.x));
    return {{"unit", "deg"}, {"from", values.front()}, {"to", values.back()}, {"values", values}};
}

Json segments_part(const Solution& solution) {
    Json all = Json::array();
    const double degrees = shown_units(solution.scene).degrees_per_x;
    for (const SegmentReport& segment : solution.segments)
        all.push_back({{"from", rounded_json(degrees * segment.begin)},
                       {"to", rounded_json(degrees * segment.end)},
                       {"title", segment_title(segment)}});
    return all;
}

Json breakpoints_part(const Solution& solution) {
    Json all = Json::array();
    const double degrees = shown_units(solution.scene).degrees_per_x;
    for (const double x : solution.motion->breakpoints()) all.push_back(rounded_json(degrees * x));
    return all;
}

constexpr std::array<const char*, 4> curve_keys = {"displacement", "velocity", "acceleration", "jerk"};

std::vector<LawStroke> strokes_for(const Solution& solution) {
    if (solution.scene.motion.type != MotionType::program) return strokes_of(solution.scene.motion);
    const CamModel model = scene_model(solution.scene, DesignKind::states, solution.reference_peaks);
    return strokes_of(solution.scene, model, solution.motion.get());
}

Json law_curves(const Motion& law, const Solution& solution, const PageRows& rows) {
    const ShownUnits units = shown_units(solution.scene);
    Json curves = Json::object();
    for (std::size_t order = 0; order < curve_keys.size(); ++order)
        curves[curve_keys[order]] = values_along(law, rows, units.motion[order].first);
    return curves;
}

// Displacement, velocity, acceleration and jerk by the cam angle, with limits, peaks and exact points.
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

Json rounded_json(double value, int digits) {
    if (!std::isfinite(value)) return nullptr;
    if (value == 0.0) return 0;
    const double power =
        std::pow(10.0, digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value)))));
    const double rounded = std::isfinite(power) && power > 0.0 ? std::round(value * power) / power : value;
    return rounded;
}

PageRows page_rows(const Solution& solution) {
    PageRows rows;
    if (!solution.motion) return rows;
    rows.rows = motion_rows(*solution.motion, solution.motion_peaks);
    rows.own = rows.rows.size();
    if (!solution.cam) return rows;
    rows.whole = cam_motion(solution);
    const double begin = solution.motion->end(), end = rows.whole->end();
    if (!(end > begin)) return rows;
    rows.rows.push_back({begin, Side::right});
    for (int i = 1; i <= dwell_steps; ++i)
        rows.rows.push_back(
            {begin + (end - begin) * i / dwell_steps, i < dwell_steps ? Side::right : Side::left});
    return rows;
}

MotionPoint page_motion_at(const Solution& solution, const PageRows& rows, std::size_t index) {
    const MotionRow& row = rows.rows[index];
    const Motion& motion = index < rows.own ? *solution.motion : *rows.whole;
    return motion.at(row.x, row.side);
}

bool page_needs_solids(const Solution& solution) {
    return solution.motion && solution.cam && has_flanks(solution);
}

std::string page_data(const Solution& solution, const RunOrigin& origin, const PageDataOptions& options) {
    Json page = Json::object();
    page["page"] = "report";
    page["camopt"] = version();
    page["title"] = solution.scene.title.empty() ? "Motion" : solution.scene.title;
    page["verdict"] = options.proof ? verdict_part(solution) : open_verdict_part(solution);
    page["figures"] = figures_part(solution);
    page["reference"] = options.proof ? reference_part(solution, options.reference) : Json(nullptr);
    const PageRows rows = page_rows(solution);
    page["angle"] = solution.motion ? angle_part(solution, rows) : Json(nullptr);
    page["curves"] = motion_curves(solution, rows);
    for (Json& curve : cam_curves(solution, rows)) page["curves"].push_back(std::move(curve));
    page["segments"] = segments_part(solution);
    page["breakpoints"] = solution.motion ? breakpoints_part(solution) : Json::array();
    page["drawing"] = plane_drawing(solution, rows);
    page["solid"] = options.solid ? solid_drawing(solution, rows) : Json(nullptr);
    page["tables"] = options.proof ? tables_part(solution) : Json::array();
    page["remarks"] = options.proof && solution.cam ? Json(cam_remarks(solution)) : Json::array();
    page["notes"] = solution.notes;
    page["appendix"] = options.proof ? appendix_part(solution, origin) : Json(nullptr);
    page["scene"] = {
        {"file", origin.scene_file}, {"text", origin.scene_text}, {"lines", scene_lines(solution.scene)}};
    return page.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<FolderFile> result_extras(const Solution& solution, const RunOrigin& origin) {
    std::vector<FolderFile> files = {{"report.html", report_html(solution, origin)}};
    if (!solution.cam || !has_flanks(solution)) return files;
    const CamFlanks cam = solved_flanks(solution);
    const MotionChain turn = whole_turn(solution);
    const FollowerMotion motion = follower_motion(turn, motion_scale(solution.scene));
    const Drum drum{solution, cam, motion};
    files.push_back({drum_picture, drum_svg(drum)});
    files.push_back({developed_picture, developed_svg(drum)});
    return files;
}

std::string page_laws(const Solution& solution, std::span<const std::string> keys) {
    Json all = Json::array();
    if (solution.motion && !keys.empty()) {
        const PageRows rows = page_rows(solution);
        const std::vector<LawStroke> strokes = strokes_for(solution);
        const bool closed = solution.scene.motion.type == MotionType::program && solution.scene.motion.closed;
        for (const std::string& key : keys) {
            const LawMotion placed = law_motion(strokes, closed, make_law(key));
            Json law = {{"key", key}, {"title", words_of(key)}, {"misfit", words_json(placed.misfit)}};
            law["curves"] = placed.motion ? law_curves(*placed.motion, solution, rows) : Json(nullptr);
            law["peaks"] = {{"velocity", rounded_json(placed.peaks.velocity.value)},
                            {"acceleration", rounded_json(placed.peaks.acceleration.value)},
                            {"jerk", rounded_json(placed.peaks.jerk.value)}};
            all.push_back(std::move(law));
        }
    }
    return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

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
