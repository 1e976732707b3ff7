// SPDX-License-Identifier: MIT
// Cam properties by the cam angle: pressure angle, curvature, regularity, loads. The extremes that are
// marked are those of the summary, so that pictures and tables name the same angles.
#include "core/units.hpp"
#include "output/chart/limit_spans.hpp"
#include "output/page/page_parts.hpp"
#include "output/words/cam_words.hpp"
#include "scene/limit_table.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/delivered/cam/follower_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace camopt {

namespace {

constexpr int extreme_digits = 6;  // as in the tables
constexpr double most_times =
    8.0;  // curvature beyond this many times that of the base circle leaves the frame

struct CamRow {
    MechanismPoint point;
    MotionPoint motion;
};

/// All that curves of a cam are made from.
struct CamCurves {
    const Solution& solution;
    const PageRows& rows;
    ShownUnits units;
    std::vector<std::vector<CamRow>> stations;  ///< by station, then by row

    [[nodiscard]] Json angle(double x) const { return rounded_json(units.degrees_per_x * x); }
    [[nodiscard]] double begin() const { return rows.whole->begin(); }
    [[nodiscard]] double end() const { return rows.whole->end(); }
};

CamCurves cam_course(const Solution& solution, const PageRows& rows) {
    CamCurves course{solution, rows, shown_units(solution.scene), {}};
    const DrivenMechanism& cam = solution.cam->cam;
    const MotionScale scale = motion_scale(solution.scene);
    course.stations.resize(static_cast<std::size_t>(cam.formulas->stations()));
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
        const MotionPoint motion = page_motion_at(solution, rows, i);
        const FollowerState state = state_of(motion, scale);
        const double theta = scale.unit_angle * rows.rows[i].x;
        for (std::size_t station = 0; station < course.stations.size(); ++station)
            course.stations[station].push_back(
                {cam.formulas->point(theta, {cam.dimensions, state, theta}, static_cast<int>(station)),
                 motion});
    }
    return course;
}

/// One curve in the making.
struct CurveText {
    const char* key;
    const char* group;
    std::string title, symbol;
    ShownUnit unit;
};

Json curve_json(const CurveText& text, Json values) {
    return {{"key", text.key},
            {"group", text.group},
            {"title", text.title},
            {"symbol", text.symbol},
            {"unit", text.unit.name},
            {"beside", nullptr},
            {"values", std::move(values)},
            {"reference", nullptr},
            {"measured", nullptr},
            {"limits", Json::array()},
            {"marks", Json::array()}};
}

/// By row: of all stations the value that counts most.
template <class Figure>
Json values_over(const CamCurves& course, const CurveText& text, const Figure& figure, bool least = false) {
    Json values = Json::array();
    for (std::size_t i = 0; i < course.rows.rows.size(); ++i) {
        std::optional<double> worst;
        for (const std::vector<CamRow>& station : course.stations) {
            const double value = figure(station[i]);
            if (std::isnan(value)) continue;
            if (!worst || (least ? value < *worst : std::abs(value) > std::abs(*worst))) worst = value;
        }
        values.push_back(worst ? rounded_json(text.unit.factor * *worst) : Json(nullptr));
    }
    return values;
}

/// What the curve shows at x: the sign of an extreme whose magnitude the summary has.
double sign_at(const CamCurves& course, double x, const std::function<double(const CamRow&)>& figure) {
    double worst = 0.0;
    const double near = 1e-9 * (course.end() - course.begin());
    std::size_t place = 0;
    while (place + 1 < course.rows.rows.size() && course.rows.rows[place].x < x - near) ++place;
    for (const std::vector<CamRow>& station : course.stations) {
        const double value = figure(station[place]);
        if (std::abs(value) > std::abs(worst)) worst = value;
    }
    return worst < 0.0 ? -1.0 : 1.0;
}

void add_mark(Json& curve, const CamCurves& course, const ShownUnit& unit,
              const std::optional<CamExtreme>& extreme, double sign, const std::string& words) {
    if (!extreme || !std::isfinite(extreme->value)) return;
    const Json at = course.angle(extreme->at);
    for (const Json& mark : curve["marks"])
        if (mark["at"] == at) return;
    curve["marks"].push_back({{"at", at},
                              {"value", rounded_json(unit.factor * sign * extreme->value)},
                              {"words", words},
                              {"given", false}});
}

void add_limit(Json& curve, double from, double to, double at, int outside, const std::string& words) {
    curve["limits"].push_back({{"from", rounded_json(from)},
                               {"to", rounded_json(to)},
                               {"at", rounded_json(at)},
                               {"outside", outside},
                               {"words", words}});
}

/// The scene's limit over the whole turn, as written.
void add_written(Json& curve, const CamCurves& course, LimitedFigure figure, double at, int outside) {
    const std::optional<WrittenLimit>& limit = limit_on(course.solution.scene.limits, figure);
    if (!limit) return;
    add_limit(curve, course.units.degrees_per_x * course.begin(), course.units.degrees_per_x * course.end(),
              at, outside, "limit");
}

Json pressure_curve(const CamCurves& course) {
    const CurveText text{"pressure_angle", "cam", "Pressure angle", "φ", course.units.angle};
    const auto figure = [](const CamRow& row) { return row.point.pressure_angle; };
    Json curve = curve_json(text, values_over(course, text, figure));
    const CamSummary& summary = course.solution.cam->summary;
    for (const auto& extreme :
         {std::optional(summary.pressure_angle), summary.rise_pressure_angle, summary.return_pressure_angle})
        if (extreme && extreme->value > 0.0) {
            const double sign = sign_at(course, extreme->at, figure);
            add_mark(curve, course, text.unit, extreme, sign,
                     text.unit.text(sign * extreme->value, extreme_digits));
        }
    for (const PressureLimit& span : pressure_spans(course.solution.scene, *course.rows.whole))
        for (const int side : {1, -1})
            add_limit(curve, span.begin / units::degree, span.end / units::degree,
                      text.unit.factor * side * span.limit, side, "limit " + text.unit.text(span.limit));
    return curve;
}

Json curvature_curve(const CamCurves& course) {
    const CurveText text{"curvature", "cam", "Curvature of the cam, > 0 convex", "κ", course.units.curvature};
    const CamSummary& summary = course.solution.cam->summary;
    const double most = most_times / summary.base_radius;
    Json curve = curve_json(text, values_over(course, text, [&](const CamRow& row) {
                                const double value = 1.0 / row.point.cam_radius;
                                return std::abs(value) > most ? std::nan("") : value;
                            }));
    const auto radius_words = [&](double radius) {
        return "radius " + course.units.length.text(radius, extreme_digits);
    };
    const auto mark = [&](const std::optional<CamExtreme>& radius, double sign) {
        if (!radius || !(radius->value > 0.0)) return;
        add_mark(curve, course, text.unit, CamExtreme{1.0 / radius->value, radius->at}, sign,
                 radius_words(radius->value));
    };
    mark(convex_radius(summary), 1.0);
    mark(summary.concave_radius, -1.0);
    const auto limit = [&](LimitedFigure figure, int side) {
        const std::optional<WrittenLimit>& radius = limit_on(course.solution.scene.limits, figure);
        if (!radius || !(radius->value > 0.0)) return;
        add_written(curve, course, figure, text.unit.factor * side / radius->value, side);
        curve["limits"].back()["words"] = "limit: " + radius_words(radius->value);
    };
    limit(LimitedFigure::convex_radius, 1);
    limit(LimitedFigure::concave_radius, -1);
    return curve;
}

/// Of cams that have no curvature of an outline: how far from undercut.
Json regularity_curve(const CamCurves& course) {
    const CurveText text{"regularity", "cam", "Regularity (0: undercut)", "g", {"", 1.0}};
    const auto figure = [](const CamRow& row) { return row.point.regularity; };
    Json curve = curve_json(text, values_over(course, text, figure, true));
    const CamExtreme& least = course.solution.cam->summary.regularity;
    add_mark(curve, course, text.unit, least, 1.0, short_text(least.value, extreme_digits));
    if (const auto& limit = limit_on(course.solution.scene.limits, LimitedFigure::regularity)) {
        add_written(curve, course, LimitedFigure::regularity, limit->value, -1);
        curve["limits"].back()["words"] = "limit " + short_text(limit->value);
    }
    return curve;
}

struct LoadCurve {
    CurveText text;
    std::function<double(const FollowerLoads&)> value;
    std::vector<std::optional<CamExtreme>> extremes;  ///< signed but for torque
    std::optional<LimitedFigure> limit;
    int outside = 1;
    bool both_sides = false;
};

Json load_curve(const CamCurves& course, const LoadCurve& load, const std::vector<FollowerLoads>& loads) {
    Json values = Json::array();
    for (const FollowerLoads& one : loads)
        values.push_back(rounded_json(load.text.unit.factor * load.value(one)));
    Json curve = curve_json(load.text, std::move(values));
    for (const std::optional<CamExtreme>& extreme : load.extremes) {
        if (!extreme) continue;
        double sign = 1.0;
        if (load.both_sides) {
            const double near = 1e-9 * course.end();
            std::size_t place = 0;
            while (place + 1 < loads.size() && course.rows.rows[place].x < extreme->at - near) ++place;
            sign = load.value(loads[place]) < 0.0 ? -1.0 : 1.0;
        }
        add_mark(curve, course, load.text.unit, extreme, sign,
                 load.text.unit.text(sign * extreme->value, extreme_digits));
    }
    if (!load.limit) return curve;
    const std::optional<WrittenLimit>& limit = limit_on(course.solution.scene.limits, *load.limit);
    if (!limit) return curve;
    for (const int side : {1, -1}) {
        if (side < 0 && !load.both_sides) continue;
        add_written(curve, course, *load.limit, load.text.unit.factor * side * limit->value,
                    load.outside * side);
        curve["limits"].back()["words"] = "limit " + load.text.unit.text(limit->value);
    }
    return curve;
}

void add_load_curves(Json& all, const CamCurves& course) {
    const std::optional<ForceSummary>& summary = course.solution.cam->summary.forces;
    const LoadsAt loads_at = delivered_loads(course.solution);
    if (!loads_at) return;
    std::vector<FollowerLoads> loads;
    for (const CamRow& row : course.stations.front()) loads.push_back(loads_at(row.motion, row.point));
    const bool swings = course.solution.cam->cam.formulas->swings();
    std::vector<LoadCurve> curves = {
        {{"force", "forces", swings ? "Moment on the follower" : "Force on the follower", swings ? "M" : "F",
          course.units.load},
         [](const FollowerLoads& one) { return one.force; },
         {summary->largest_force, summary->least_force},
         LimitedFigure::contact_force,
         -1},
        {{"torque", "forces", "Camshaft torque", "T", course.units.torque},
         [](const FollowerLoads& one) { return one.torque; },
         {summary->torque},
         LimitedFigure::torque,
         1,
         true},
        {{"normal_force", "forces", "Force along the normal", "N", course.units.force},
         [](const FollowerLoads& one) { return one.normal_force; },
         {summary->normal_force},
         std::nullopt}};
    if (summary->hertz_pressure)
        curves.push_back({{"hertz_pressure", "forces", "Hertz pressure", "p", course.units.pressure},
                          [](const FollowerLoads& one) { return one.hertz_pressure.value_or(std::nan("")); },
                          {summary->hertz_pressure},
                          LimitedFigure::hertz_pressure});
    for (const LoadCurve& curve : curves) {
        const bool without_contact = summary->normal_force && std::isinf(summary->normal_force->value);
        if (without_contact && (curve.text.symbol == "N" || curve.text.symbol == "p")) continue;
        all.push_back(load_curve(course, curve, loads));
    }
}

}  // namespace

Json cam_curves(const Solution& solution, const PageRows& rows) {
    Json all = Json::array();
    if (!solution.cam || !rows.whole) return all;
    const CamCurves course = cam_course(solution, rows);
    const CamMechanism& formulas = *solution.cam->cam.formulas;
    // A translating flat face has the pressure angle 0 everywhere: nothing to draw.
    if (solution.cam->summary.pressure_angle.value > 0.0) all.push_back(pressure_curve(course));
    if (formulas.planar())
        all.push_back(curvature_curve(course));
    else
        all.push_back(regularity_curve(course));
    add_load_curves(all, course);
    return all;
}

}  // namespace camopt
