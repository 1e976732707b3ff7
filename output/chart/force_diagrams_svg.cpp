// SPDX-License-Identifier: MIT
#include "output/chart/force_diagrams_svg.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/chart/turn_diagram.hpp"
#include "output/words/number_text.hpp"
#include "output/words/shown_units.hpp"
#include "profiles/disk/disk_mechanism.hpp"
#include "scene/limit_table.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/delivered/cam/follower_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace camopt {

namespace {

using units::degree;

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
    const DiskCam cam = disk_cam(solution.cam->cam).value();
    const ForceSpec& forces = *solution.scene.forces;
    const double speed = *solution.scene.motion.speed;
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
            const FollowerState state = state_of(motion.at(x, k == count ? Side::left : Side::right), scale);
            const double theta = scale.unit_angle * x;
            piece.push_back(
                {theta / degree, follower_loads(cam, forces, speed, state,
                                                mechanism_point(profile_point(cam, theta, state)))});
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
    std::vector<LoadQuantity> all = {{swings ? "Moment that presses the follower on the cam M"
                                             : "Force that presses the follower on the cam F",
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
