// SPDX-License-Identifier: MIT
// Quantities of the cam by the cam angle: pressure angle, curvature, regularity, loads. The extremes that are
// marked are those of the summary, so that pictures and tables name the same angles.
#include "report/view/cam_words.hpp"
#include "report/view/view.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// A curvature beyond this many times that of the base circle, and beyond this many times that of a limit, is
// not drawn.
constexpr double most_times = 8.0, most_of_limit = 1.5;
constexpr int every_station = -1;

using PointFigure = std::function<double(const MechanismPoint&)>;
using LoadFigure = std::function<double(const FollowerLoads&)>;

void add_mark(Curve& curve, const View& view, const std::optional<CamExtreme>& extreme, double sign,
              std::string words = {}) {
    if (!extreme || !std::isfinite(extreme->value)) return;
    const double at = view.degrees(extreme->at);
    if (std::ranges::find(curve.marks, at, &CurveMark::at) != curve.marks.end()) return;
    if (words.empty()) words = curve.unit.text(sign * extreme->value, curve_mark_digits);
    curve.marks.push_back({at, curve.unit.of(sign * extreme->value), std::move(words)});
}

/// The scene's limit on that figure over the whole cam, drawn at `at` (SI).
void add_limit(Curve& curve, const View& view, double at, int outside, std::string words) {
    curve.limits.push_back(
        {view.angles.front(), view.angles.back(), curve.unit.of(at), outside, std::move(words)});
}

/// Of one station, or of the station where the magnitude is largest (`least`: where the value is least).
double over_stations(const DeliveredRow& row, int station, const PointFigure& figure, bool least) {
    if (station != every_station) return figure(row.cam[station]);
    double worst = std::nan("");
    for (const MechanismPoint& point : row.cam) {
        const double value = figure(point);
        if (std::isnan(value)) continue;
        const bool first = std::isnan(worst);
        if (first || (least ? value < worst : std::abs(value) > std::abs(worst))) worst = value;
    }
    return worst;
}

void add_values(Curve& curve, const View& view, int station, const PointFigure& figure, bool least = false) {
    for (const DeliveredRow& row : view.delivered.rows)
        curve.values.push_back(curve.unit.of(over_stations(row, station, figure, least)));
}

/// The summary has the magnitude of an extreme; the curve has its sign.
double sign_at(const Curve& curve, const View& view, double x) {
    return curve.values[view.delivered.index_at(x)] < 0.0 ? -1.0 : 1.0;
}

/// Of one station: its name in the title, and in the key of all but the first its number.
Curve curve_at(const View& view, int station, Curve curve) {
    if (station == every_station) return curve;
    if (station > 0) curve.key += fmt::format("_{}", station + 1);
    curve.title += ", " + view.solution.cam->cam.formulas->station_name(station);
    return curve;
}

Curve pressure_curve(const View& view, int station) {
    Curve curve = curve_at(view, station, {"pressure_angle", "cam", "Pressure angle", "φ", view.units.angle});
    add_values(curve, view, station, [](const MechanismPoint& point) { return point.pressure_angle; });
    const CamSummary& summary = view.solution.cam->summary;
    std::vector<std::optional<CamExtreme>> extremes = {summary.pressure_angle, summary.rise_pressure_angle,
                                                       summary.return_pressure_angle};
    if (station != every_station) extremes = {summary.sides[station].pressure_angle};
    for (const auto& extreme : extremes)
        if (extreme && extreme->value > 0.0)
            add_mark(curve, view, extreme, sign_at(curve, view, extreme->at));
    for (const PressureLimit& span : pressure_spans(view.solution.scene, *view.delivered.whole))
        for (const int side : {1, -1})
            curve.limits.push_back({span.begin / units::degree, span.end / units::degree,
                                    curve.unit.of(side * span.limit), side,
                                    "limit " + curve.unit.text(span.limit)});
    return curve;
}

Curve curvature_curve(const View& view, int station) {
    const CamSummary& summary = view.solution.cam->summary;
    const LimitSpec& limits = view.solution.scene.limits;
    double most = most_times / summary.base_radius;
    for (const LimitedFigure radius : {LimitedFigure::convex_radius, LimitedFigure::concave_radius})
        if (const auto& limit = limit_on(limits, radius); limit && limit->value > 0.0)
            most = std::max(most, most_of_limit / limit->value);
    Curve curve = curve_at(
        view, station, {"curvature", "cam", "Curvature of the cam, > 0 convex", "κ", view.units.curvature});
    add_values(curve, view, station, [most](const MechanismPoint& point) {
        const double value = 1.0 / point.cam_radius;
        return std::abs(value) > most ? std::nan("") : value;
    });
    const auto radius_words = [&](double radius) {
        return "radius " + view.units.length.text(radius, curve_mark_digits);
    };
    const auto mark = [&](const std::optional<CamExtreme>& radius, double sign) {
        if (!radius || !(radius->value > 0.0)) return;
        add_mark(curve, view, CamExtreme{1.0 / radius->value, radius->at}, sign, radius_words(radius->value));
    };
    if (station == every_station) {
        mark(convex_radius(summary), 1.0);
        mark(summary.concave_radius, -1.0);
    } else {
        const SideSummary& side = summary.sides[station];
        mark(side.convex_radius, 1.0);
        mark(side.concave_radius, -1.0);
    }
    for (const auto& [limit, side] : {std::pair(limit_on(limits, LimitedFigure::convex_radius), 1),
                                      std::pair(limit_on(limits, LimitedFigure::concave_radius), -1)})
        if (limit && limit->value > 0.0)
            add_limit(curve, view, side / limit->value, side, "limit: " + radius_words(limit->value));
    return curve;
}

/// Of cams that have no curvature of an outline: how far from undercut.
Curve regularity_curve(const View& view) {
    Curve curve{"regularity", "cam", "Regularity (0: undercut)", "g", {}};
    add_values(
        curve, view, every_station, [](const MechanismPoint& point) { return point.regularity; }, true);
    const CamExtreme& least = view.solution.cam->summary.regularity;
    add_mark(curve, view, least, 1.0, short_text(least.value, curve_mark_digits));
    if (const auto& limit = limit_on(view.solution.scene.limits, LimitedFigure::regularity))
        add_limit(curve, view, limit->value, -1, "limit " + short_text(limit->value));
    return curve;
}

struct LoadRow {
    Curve curve;
    LoadFigure value;
    std::vector<std::optional<CamExtreme>> extremes;  ///< signed but for a magnitude
    std::optional<LimitedFigure> limit;
    int outside = 1;
    bool magnitude = false;
    std::optional<LimitedFigure> other = {};  ///< of the other side
};

Curve load_curve(const View& view, LoadRow load) {
    Curve curve = std::move(load.curve);
    for (const DeliveredRow& row : view.delivered.rows)
        curve.values.push_back(curve.unit.of(load.value(*row.loads)));
    for (const std::optional<CamExtreme>& extreme : load.extremes)
        if (extreme) add_mark(curve, view, extreme, load.magnitude ? sign_at(curve, view, extreme->at) : 1.0);
    if (load.other)
        if (const auto& limit = limit_on(view.solution.scene.limits, *load.other))
            add_limit(curve, view, limit->value, -load.outside, "limit " + curve.unit.text(limit->value));
    if (!load.limit) return curve;
    const std::optional<WrittenLimit>& limit = limit_on(view.solution.scene.limits, *load.limit);
    if (!limit) return curve;
    for (const int side : {1, -1})
        if (side > 0 || load.magnitude)
            add_limit(curve, view, side * limit->value, load.outside * side,
                      "limit " + curve.unit.text(limit->value));
    return curve;
}

void add_loads(std::vector<Curve>& all, const View& view) {
    const std::optional<ForceSummary>& summary = view.solution.cam->summary.forces;
    if (!is_loaded(view.solution.cam->summary) || !view.delivered.rows.front().loads) return;
    const bool swings = view.solution.cam->cam.formulas->swings();
    all.push_back(load_curve(
        view, {{"force", "forces",
                swings ? "Moment pressing the follower on the cam" : "Force pressing the follower on the cam",
                swings ? "M" : "F", view.units.load},
               [](const FollowerLoads& one) { return one.force; },
               {summary->largest_force, summary->least_force},
               LimitedFigure::contact_force,
               -1,
               false,
               LimitedFigure::contact_force_most}));
    all.push_back(load_curve(
        view, {{"torque", "forces", "Camshaft torque, > 0: the shaft drives", "T", view.units.torque},
               [](const FollowerLoads& one) { return one.torque; },
               {summary->torque},
               LimitedFigure::torque,
               1,
               true}));
    if (summary->driving_force)
        all.push_back(load_curve(
            view, {{"driving_force", "forces", "Force along the travel, > 0: the plate is pushed", "P",
                    view.units.force},
                   [](const FollowerLoads& one) { return one.driving_force.value_or(std::nan("")); },
                   {summary->driving_force},
                   std::nullopt,
                   1,
                   true}));
    if (view.solution.cam->summary.no_contact) return;  // neither exists
    if (summary->normal_force)
        all.push_back(
            load_curve(view, {{"normal_force", "forces", "Force along the normal", "N", view.units.force},
                              [](const FollowerLoads& one) { return one.normal_force; },
                              {summary->normal_force},
                              std::nullopt}));
    if (summary->hertz_pressure)
        all.push_back(load_curve(
            view, {{"hertz_pressure", "forces", "Hertz pressure", "p", view.units.pressure},
                   [](const FollowerLoads& one) { return one.hertz_pressure.value_or(std::nan("")); },
                   {summary->hertz_pressure},
                   LimitedFigure::hertz_pressure}));
}

}  // namespace

std::vector<Curve> cam_curves(const View& view) {
    const CamMechanism& formulas = *view.solution.cam->cam.formulas;
    const CamSummary& summary = view.solution.cam->summary;
    // Each side of a cam that drives both ways has a curvature; disks on one shaft have pressure angles too.
    const int sides = static_cast<int>(summary.sides.size());
    const bool two_disks =
        sides > 0 && formulas.limit_structure().binds(MechanismQuantity::pressure_numerator, sides - 1);
    std::vector<Curve> all;
    // A translating flat face has the pressure angle 0 everywhere: nothing to draw.
    if (summary.pressure_angle.value > 0.0)
        for (int side = 0; side < (two_disks ? sides : 1); ++side)
            all.push_back(pressure_curve(view, two_disks ? side : every_station));
    const bool has_outline = formulas.radius_quantity().has_value();
    if (!has_outline) all.push_back(regularity_curve(view));
    for (int side = 0; has_outline && side < std::max(sides, 1); ++side)
        all.push_back(curvature_curve(view, sides > 0 ? side : every_station));
    add_loads(all, view);
    return all;
}

}  // namespace camopt
