// SPDX-License-Identifier: MIT
#include "output/drawing/mechanism_figures.hpp"

#include "core/units.hpp"
#include "output/chart/placed_texts.hpp"
#include "output/chart/turn_diagram.hpp"
#include "output/drawing/picture_page.hpp"
#include "output/words/cam_words.hpp"
#include "output/words/number_text.hpp"
#include "output/words/shown_units.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace camopt {

namespace {

using units::degree;

constexpr double points_a_turn = 3600.0;

std::string title_of_cam(const Solution& solution) {
    return solution.scene.title.empty() ? "Cam" : solution.scene.title;
}

/// Piece by piece between the motion's breakpoints.
template <class Figure>
std::vector<std::vector<Eigen::Vector2d>> pieces_of(const MechanismProfile& profile, const Figure& figure) {
    std::vector<std::vector<Eigen::Vector2d>> pieces(1);
    for (const MechanismPoint& point : profile.points)
        pieces.back().emplace_back(point.theta / degree, figure(point));
    return pieces;
}

TurnDiagram diagram_of(const Solution& solution, const MechanismProfile& profile, TurnPanel panel) {
    TurnDiagram diagram{title_of_cam(solution),
                        profile.points.front().theta / degree,
                        profile.points.back().theta / degree,
                        {},
                        {}};
    for (const int index : profile.breaks)
        diagram.knots.push_back(profile.points[static_cast<std::size_t>(index)].theta / degree);
    diagram.panels.push_back(std::move(panel));
    return diagram;
}

/// The value there is that of the nearest point: its sign is what the extreme does not tell.
double near(const MechanismProfile& profile, double theta, double MechanismPoint::*figure) {
    const auto distance = [&](const MechanismPoint& point) { return std::abs(point.theta - theta); };
    return (*std::ranges::min_element(profile.points, {}, distance)).*figure;
}

using Eigen::Vector2d;

const char* const guide_style =
    ".slot{fill:#d9e8f2;stroke:none}.wall-left{fill:none;stroke:#0072b2;stroke-width:2.2;stroke-linejoin:"
    "round}"
    ".wall-right{fill:none;stroke:#d55e00;stroke-width:2.2;stroke-linejoin:round}"
    ".pitch{fill:none;stroke:#555;stroke-width:1.2;stroke-dasharray:7 4}"
    ".roller{fill:#fff;fill-opacity:.75;stroke:#b35900;stroke-width:1.8}.pivot{fill:#222;stroke:#222;stroke-"
    "width:6}"
    ".label{paint-order:stroke;stroke:#fff;stroke-width:4px}";

std::vector<Vector2d> line_of(const MechanismProfile& profile, Eigen::Vector3d MechanismPoint::*place) {
    std::vector<Vector2d> line;
    for (const MechanismPoint& point : profile.points) line.emplace_back((point.*place).head<2>());
    return line;
}

}  // namespace

std::string pressure_angle_svg(const Solution& solution, const MechanismProfile& profile) {
    TurnPanel panel;
    panel.least_range = 2.0;
    panel.caption = "Pressure angle φ";
    panel.unit = "deg";
    panel.pieces =
        pieces_of(profile, [](const MechanismPoint& point) { return point.pressure_angle / degree; });
    panel.words = [](double value) { return fmt::format("φ = {}°", short_text(value, 4)); };
    const double begin = profile.points.front().theta / degree, end = profile.points.back().theta / degree;
    if (const auto& limit = limit_on(solution.scene.limits, LimitedFigure::pressure_angle))
        for (const double sign : {1.0, -1.0})
            panel.limits.push_back(
                {begin, end, sign * limit->value / degree,
                 sign > 0.0 ? fmt::format("limit {}°", short_text(limit->value / degree)) : ""});
    const CamExtreme& largest = solution.cam->summary.pressure_angle;
    const double theta = solution.scene.motion.unit_angle() * largest.at;
    const double signed_value =
        std::copysign(largest.value, near(profile, theta, &MechanismPoint::pressure_angle)) / degree;
    panel.marks = std::vector<TurnMark>{{theta / degree, signed_value, signed_value > 0.0}};
    return turn_diagram_svg(diagram_of(solution, profile, std::move(panel)));
}

std::string curvature_svg(const Solution& solution, const MechanismProfile& profile) {
    const ShownUnits units = shown_units(solution.scene);
    const double unit_angle = solution.scene.motion.unit_angle();
    TurnPanel panel;
    panel.caption = "Curvature of the cam 1/ρ (convex > 0, concave < 0)";
    panel.unit = units.curvature.name;
    panel.pieces = pieces_of(
        profile, [&](const MechanismPoint& point) { return units.curvature.factor / point.cam_radius; });
    panel.words = [name = units.length.name](double value) {
        return fmt::format("ρ = {} {}", short_text(1.0 / value, 4), name);
    };
    const double begin = profile.points.front().theta / degree, end = profile.points.back().theta / degree;
    for (const auto& [figure, sign, name] : {std::tuple{LimitedFigure::convex_radius, 1.0, "convex"},
                                             std::tuple{LimitedFigure::concave_radius, -1.0, "concave"}})
        if (const auto& limit = limit_on(solution.scene.limits, figure); limit && limit->value > 0.0)
            panel.limits.push_back(
                {begin, end, sign * units.curvature.factor / limit->value,
                 fmt::format("least {} radius {}", name, units.length.text(limit->value))});
    std::vector<TurnMark> marks;
    const CamSummary& summary = solution.cam->summary;
    if (const std::optional<CamExtreme> convex = convex_radius(summary))
        marks.push_back({unit_angle * convex->at / degree, units.curvature.factor / convex->value, true});
    if (summary.concave_radius)
        marks.push_back({unit_angle * summary.concave_radius->at / degree,
                         -units.curvature.factor / summary.concave_radius->value, false});
    panel.marks = std::move(marks);
    return turn_diagram_svg(diagram_of(solution, profile, std::move(panel)));
}

int default_profile_points(const Motion& motion, const MotionScale& scale) {
    const double turns = (motion.end() - motion.begin()) * scale.unit_angle / units::turn;
    return 1 + static_cast<int>(std::ceil(points_a_turn * turns));
}

std::string guide_svg(const Solution& solution, const GuideWalls& walls) {
    const std::string title = solution.scene.title.empty() ? "Inverse cam" : solution.scene.title;
    const std::vector<Vector2d> left = line_of(walls.left, &MechanismPoint::contact),
                                right = line_of(walls.right, &MechanismPoint::contact),
                                middle = line_of(walls.left, &MechanismPoint::pitch);
    PictureBox box;
    box.add(Vector2d::Zero());
    const double radius = (left.front() - middle.front()).norm();
    for (const std::vector<Vector2d>* line : {&left, &right, &middle})
        for (const Vector2d& point : *line) box.add(point);
    for (const Vector2d& point : {middle.front(), middle.back()}) {
        box.add(point - Vector2d::Constant(radius));
        box.add(point + Vector2d::Constant(radius));
    }
    SvgCanvas canvas(picture_width, picture_height, guide_style + std::string(picture_style()), title);
    canvas.rectangle(0, 0, picture_width, picture_height, "page");
    canvas.text(picture_left, 38, title, "title");
    const ProfileCanvas on = fitted_canvas(canvas, box.with_room());
    const ShownUnit length = shown_units(solution.scene).length;
    draw_length_frame(on, length, "x, y in " + length.name + " (frame of the body)");
    std::vector<Vector2d> slot = left;
    slot.insert(slot.end(), right.rbegin(), right.rend());
    on.polyline(slot, true, "slot");
    on.polyline(left, false, "wall-left");
    on.polyline(right, false, "wall-right");
    on.polyline(middle, false, "pitch");
    PlacedTexts labels(picture_left + 4, picture_top + 4, picture_left + picture_frame_width - 4,
                       picture_top + picture_frame_height - 4);
    const auto label = [&](const Vector2d& at, double distance, const std::string& words) {
        const Vector2d px = on.place(at);
        const std::vector<TextPlace> places = {{px.x(), px.y() + distance + 11, TextSide::middle},
                                               {px.x(), px.y() - distance - 3, TextSide::middle},
                                               {px.x() + distance + 3, px.y() + 4, TextSide::start},
                                               {px.x() - distance - 3, px.y() + 4, TextSide::end},
                                               {px.x() + distance, px.y() + distance + 11, TextSide::end}};
        labels.draw(canvas, words, places, "label");
    };
    for (const auto& [point, end] : {std::pair{middle.front(), &walls.left.points.front()},
                                     std::pair{middle.back(), &walls.left.points.back()}}) {
        on.circle(point, radius, "roller");
        label(point, on.scale * radius, fmt::format("θ = {}°", short_text(end->theta / units::degree, 5)));
    }
    on.circle({0.0, 0.0}, on.px(5), "pivot");
    label({0.0, 0.0}, 6, "body's pivot");
    LegendColumn column(canvas, length, 8 + dimension_entries(solution) + figure_entries(solution));
    column.sample("wall-left", "left wall");
    column.sample("wall-right", "right wall");
    column.sample("pitch", "path of the roller's centre");
    column.sample("roller", "roller at both ends");
    column.heading("dimensions");
    add_dimensions(column, solution);
    column.heading("figures");
    add_figures(column, solution);
    return canvas.finish();
}

}  // namespace camopt
