// SPDX-License-Identifier: MIT
#include "output/drawing/mechanism_figures.hpp"

#include "core/units.hpp"
#include "output/chart/svg_canvas.hpp"
#include "output/drawing/picture_page.hpp"
#include "output/words/number_text.hpp"
#include "output/words/shown_units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

namespace camopt {

namespace {

constexpr double points_a_turn = 3600.0;

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

int default_profile_points(const Motion& motion, const MotionScale& scale) {
    const double turns = (motion.end() - motion.begin()) * scale.unit_angle / units::turn;
    return 1 + static_cast<int>(std::ceil(points_a_turn * turns));
}

std::string guide_svg(const Solution& solution, const GuideWalls& walls) {
    const std::string title = solution.scene.title.empty() ? "Guide" : solution.scene.title;
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
