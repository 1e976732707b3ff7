// SPDX-License-Identifier: MIT
#include "output/chart/profile_diagrams_svg.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/chart/turn_diagram.hpp"
#include "output/words/number_text.hpp"
#include "output/words/shown_units.hpp"
#include "scene/limit_table.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/delivered/cam/follower_loads.hpp"
#include "studies/delivered/driven_mechanism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

namespace camopt {

namespace {

using units::degree;

constexpr int diagram_steps = 2880;     // an eighth of a degree
constexpr double most_curvature = 6.0;  // of the largest of base circle's and limits' curvature: then cut off

using Pieces = std::vector<std::vector<MechanismPoint>>;

/// value: in the unit shown.
std::vector<std::vector<Eigen::Vector2d>> curve_of(
    const Pieces& pieces, const std::function<double(const MechanismPoint&)>& value) {
    std::vector<std::vector<Eigen::Vector2d>> curve;
    for (const std::vector<MechanismPoint>& piece : pieces) {
        curve.emplace_back();
        for (const MechanismPoint& point : piece)
            curve.back().emplace_back(point.theta / degree, value(point));
    }
    return curve;
}

TurnPanel pressure_panel(const Pieces& pieces, const ProfileDiagramLimits& limits) {
    TurnPanel panel;
    panel.least_range = 2.0;
    panel.caption = "Pressure angle φ";
    panel.unit = "deg";
    panel.pieces =
        curve_of(pieces, [](const MechanismPoint& point) { return point.pressure_angle / degree; });
    panel.words = [](double value) { return fmt::format("φ = {}°", short_text(value, 4)); };
    for (const PressureLimit& limit : limits.pressure)
        for (const double sign : {1.0, -1.0})
            panel.limits.push_back(
                {limit.begin / degree, limit.end / degree, sign * limit.limit / degree,
                 sign > 0.0 ? fmt::format("limit {}°", short_text(limit.limit / degree)) : ""});
    return panel;
}

TurnPanel curvature_panel(const ProfileShape& shape, const Pieces& pieces,
                          const ProfileDiagramLimits& limits) {
    const ShownUnit length = shape.length;
    TurnPanel panel;
    panel.caption = "Curvature of the cam 1/ρ (convex > 0, concave < 0)";
    panel.unit = "1/" + length.name;
    panel.pieces = curve_of(
        pieces, [&](const MechanismPoint& point) { return 1.0 / (length.factor * point.cam_radius); });
    panel.words = [name = length.name](double value) {
        return fmt::format("ρ = {} {}", short_text(1.0 / value, 4), name);
    };
    panel.bound = most_curvature / (length.factor * shape.base_radius());
    const auto add = [&](const std::optional<double>& radius, double sign, const char* name) {
        if (!radius || !(*radius > 0.0)) return;
        const double value = sign / (length.factor * *radius);
        panel.bound = std::max(panel.bound, 1.5 * std::abs(value));
        panel.limits.push_back({shape.begin() / degree, shape.end() / degree, value,
                                fmt::format("least {} radius {}", name, length.text(*radius))});
    };
    add(limits.convex_radius_min, 1.0, "convex");
    add(limits.concave_radius_min, -1.0, "concave");
    return panel;
}

/// factor: from SI to the unit shown.
std::vector<TurnMark> shown_marks(const std::vector<ProfileMark>& marks, double factor) {
    std::vector<TurnMark> shown;
    shown.reserve(marks.size());
    for (const ProfileMark& mark : marks)
        shown.push_back({mark.theta / degree, factor * mark.value, mark.value > 0.0});
    return shown;
}

/// The curvature of either side, and of conjugate disks the pressure angle of either.
TurnDiagram two_sided(TurnDiagram diagram, const TurnPanel& pressure, const ProfileShape& shape,
                      const ProfileDiagramLimits& limits) {
    const CamMechanism& cam = shape.formulas();
    const bool two_disks = shape.has_two_disks();
    const ProfileShape other = other_side(shape);
    const std::array<const ProfileShape*, 2> sides = {&shape, &other};
    for (int side = 0; side < 2; ++side) {
        const ProfileShape& own = *sides[static_cast<std::size_t>(side)];
        const Pieces pieces = profile_pieces(own, diagram_steps);
        if (side == 0 || two_disks) {
            TurnPanel panel = pressure_panel(pieces, limits);
            if (two_disks) panel.caption += ", " + cam.station_name(side);
            if (side == 0 && !two_disks) panel.marks = pressure.marks;
            diagram.panels.push_back(std::move(panel));
        }
        diagram.panels.push_back(curvature_panel(own, pieces, limits));
        diagram.panels.back().caption =
            fmt::format("Curvature, {}, 1/ρ (convex > 0, concave < 0)", cam.station_name(side));
    }
    return diagram;
}

constexpr int load_steps = 2880;     // over the motion: an eighth of a degree of a turn
constexpr int least_load_steps = 8;  // of a piece between two breakpoints
constexpr int mark_digits = 4;

struct LoadPoint {
    double theta_deg = 0.0;
    FollowerLoads load;
};
using LoadPieces = std::vector<std::vector<LoadPoint>>;

/// What all panels share.
struct LoadPicture {
    const Solution& solution;
    ShownUnits shown;
    LoadPieces pieces;
    double begin = 0.0, end = 0.0;  ///< deg
    double unit_angle_deg = 1.0;
};

/// The forces jump where the acceleration does: each piece between two breakpoints is seen from inside.
LoadPieces load_pieces(const Solution& solution, const Motion& motion) {
    const DrivenMechanism& cam = solution.cam->cam;
    const LoadsAt loads = delivered_loads(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const std::vector<double> places = motion.breakpoints();
    LoadPieces pieces;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const double length = places[i + 1] - places[i];
        const int count =
            std::max(least_load_steps,
                     static_cast<int>(std::ceil(load_steps * length / (places.back() - places.front()))));
        std::vector<LoadPoint>& piece = pieces.emplace_back();
        for (int k = 0; k <= count; ++k) {
            const double x = k == count ? places[i + 1] : places[i] + length * k / count;
            const MotionPoint point = motion.at(x, k == count ? Side::left : Side::right);
            piece.push_back(
                {scale.unit_angle * x / degree, loads(point, mechanism_point(cam, point, scale))});
        }
    }
    return pieces;
}

using LoadFigure = double (*)(const FollowerLoads&);

/// One quantity as its panel shows it.
struct LoadQuantity {
    const char* caption;
    const char* symbol;
    LoadFigure figure;
    ShownUnit unit;
    std::vector<std::pair<CamExtreme, bool>> extremes;  ///< and whether it is a least value
    const std::optional<WrittenLimit>& limit;
    bool to_either_side = false;  ///< the limit is on the magnitude
};

/// The value of the curve where the report has its extreme: of a magnitude with its sign.
double signed_value(const LoadPicture& picture, const LoadQuantity& quantity, const CamExtreme& extreme) {
    if (!quantity.to_either_side) return extreme.value;
    const double at = extreme.at * picture.unit_angle_deg;
    double nearest = HUGE_VAL, sign = 1.0;
    for (const std::vector<LoadPoint>& piece : picture.pieces)
        for (const LoadPoint& point : piece)
            if (const double distance = std::abs(point.theta_deg - at); distance < nearest) {
                nearest = distance;
                sign = quantity.figure(point.load);
            }
    return std::copysign(extreme.value, sign);
}

TurnPanel panel_of(const LoadPicture& picture, const LoadQuantity& quantity) {
    const ShownUnit& unit = quantity.unit;
    TurnPanel panel;
    panel.caption = quantity.caption;
    panel.unit = unit.name;
    for (const std::vector<LoadPoint>& piece : picture.pieces) {
        panel.pieces.emplace_back();
        for (const LoadPoint& point : piece)
            panel.pieces.back().emplace_back(point.theta_deg, unit.factor * quantity.figure(point.load));
    }
    panel.words = [symbol = quantity.symbol, name = unit.name](double value) {
        return fmt::format("{} = {} {}", symbol, short_text(value, mark_digits), name);
    };
    panel.marks.emplace();
    for (const auto& [extreme, least] : quantity.extremes) {
        const double value = unit.factor * signed_value(picture, quantity, extreme);
        panel.marks->push_back({extreme.at * picture.unit_angle_deg, value, !least && value > 0.0});
    }
    if (!quantity.limit) return panel;
    const double limit = unit.factor * quantity.limit->value;
    panel.limits.push_back(
        {picture.begin, picture.end, limit, fmt::format("limit {} {}", short_text(limit), unit.name)});
    if (quantity.to_either_side) panel.limits.push_back({picture.begin, picture.end, -limit, ""});
    return panel;
}

std::vector<LoadQuantity> quantities_of(const LoadPicture& picture) {
    const ForceSummary& forces = *picture.solution.cam->summary.forces;
    const LimitSpec& limits = picture.solution.scene.limits;
    static const std::optional<WrittenLimit> unlimited;
    const ShownUnits& shown = picture.shown;
    const bool swings = picture.solution.scene.motion.lift_is_angle;
    std::vector<LoadQuantity> all = {
        {swings ? "Moment of the follower on the cam M" : "Force of the follower on the cam F",
         swings ? "M" : "F",
         [](const FollowerLoads& load) { return load.force; },
         shown.load,
         {{forces.largest_force, false}, {forces.least_force, true}},
         limit_on(limits, LimitedFigure::contact_force)},
        {"Torque of the camshaft T (> 0: the shaft drives)",
         "T",
         [](const FollowerLoads& load) { return load.torque; },
         shown.torque,
         {{forces.torque, false}},
         limit_on(limits, LimitedFigure::torque),
         true}};
    if (picture.solution.cam->summary.no_contact) return all;
    if (forces.normal_force)
        all.push_back({"Force along the normal N",
                       "N",
                       [](const FollowerLoads& load) { return load.normal_force; },
                       shown.force,
                       {{*forces.normal_force, false}},
                       unlimited});
    if (forces.hertz_pressure)
        all.push_back({"Hertz pressure p",
                       "p",
                       [](const FollowerLoads& load) { return load.hertz_pressure.value_or(0.0); },
                       shown.pressure,
                       {{*forces.hertz_pressure, false}},
                       limit_on(limits, LimitedFigure::hertz_pressure)});
    return all;
}

}  // namespace

std::string profile_diagrams_svg(const ProfileShape& shape, const ProfileDiagramLimits& limits,
                                 std::string_view title, const std::optional<ProfileDiagramMarks>& marks) {
    const Pieces pieces = profile_pieces(shape, diagram_steps);
    TurnPanel pressure = pressure_panel(pieces, limits), curvature = curvature_panel(shape, pieces, limits);
    if (marks) {
        pressure.marks = shown_marks(marks->pressure, 1.0 / degree);
        curvature.marks = shown_marks(marks->curvature, 1.0 / shape.length.factor);
    }
    TurnDiagram diagram{std::string(title), shape.begin() / degree, shape.end() / degree, {}, {}};
    for (const double knot : shape.knots) diagram.knots.push_back(knot / degree);
    if (shape.other) return turn_diagram_svg(two_sided(std::move(diagram), pressure, shape, limits));
    // The pressure angle of a translating flat face is 0 everywhere: nothing to draw.
    if (!shape.has_pushed_face()) diagram.panels.push_back(std::move(pressure));
    diagram.panels.push_back(std::move(curvature));
    return turn_diagram_svg(diagram);
}

std::string force_diagrams_svg(const Solution& solution, const Motion& motion) {
    if (!solution.cam || !solution.cam->summary.forces)
        throw InputError("forces.svg needs forces, and this solution has none");
    const double unit_angle_deg = solution.scene.motion.unit_angle() / degree;
    const LoadPicture picture{solution,
                              shown_units(solution.scene),
                              load_pieces(solution, motion),
                              unit_angle_deg * motion.begin(),
                              unit_angle_deg * motion.end(),
                              unit_angle_deg};
    TurnDiagram diagram{solution.scene.title.empty() ? "Forces" : solution.scene.title + ": forces",
                        picture.begin,
                        picture.end,
                        {},
                        {}};
    for (const double x : motion.breakpoints()) diagram.knots.push_back(unit_angle_deg * x);
    for (const LoadQuantity& quantity : quantities_of(picture))
        diagram.panels.push_back(panel_of(picture, quantity));
    return turn_diagram_svg(diagram);
}

}  // namespace camopt
