// SPDX-License-Identifier: MIT
#include "output/chart/profile_diagrams_svg.hpp"

#include "core/units.hpp"
#include "output/chart/turn_diagram.hpp"
#include "output/words/number_text.hpp"
#include "profiles/disk/disk_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

namespace camopt {

namespace {

using units::degree;

constexpr int diagram_steps = 2880;     // an eighth of a degree
constexpr double most_curvature = 6.0;  // of the largest of base circle's and limits' curvature: then cut off

using Pieces = std::vector<std::vector<ProfilePoint>>;

/// value: in the unit shown.
std::vector<std::vector<Eigen::Vector2d>> curve_of(const Pieces& pieces,
                                                   const std::function<double(const ProfilePoint&)>& value) {
    std::vector<std::vector<Eigen::Vector2d>> curve;
    for (const std::vector<ProfilePoint>& piece : pieces) {
        curve.emplace_back();
        for (const ProfilePoint& point : piece) curve.back().emplace_back(point.theta / degree, value(point));
    }
    return curve;
}

TurnPanel pressure_panel(const Pieces& pieces, const ProfileDiagramLimits& limits) {
    TurnPanel panel;
    panel.least_range = 2.0;
    panel.caption = "Pressure angle φ";
    panel.unit = "deg";
    panel.pieces = curve_of(pieces, [](const ProfilePoint& point) { return point.pressure_angle / degree; });
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
    panel.pieces =
        curve_of(pieces, [&](const ProfilePoint& point) { return 1.0 / (length.factor * point.cam_radius); });
    panel.words = [name = length.name](double value) {
        return fmt::format("ρ = {} {}", short_text(1.0 / value, 4), name);
    };
    panel.bound = most_curvature / (length.factor * shape.cam[DimensionIndex::base_radius]);
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
    for (const ProfileMark& mark : marks)
        shown.push_back({mark.theta / degree, factor * mark.value, mark.value > 0.0});
    return shown;
}

/// The curvature of either side, and of conjugate disks the pressure angle of either.
TurnDiagram two_sided(TurnDiagram diagram, TurnPanel pressure, const ProfileShape& shape,
                      const ProfileDiagramLimits& limits) {
    const FormSpec& form = shape.cam.form;
    const ProfileShape other = other_side(shape);
    const std::array<const ProfileShape*, 2> sides = {&shape, &other};
    for (int side = 0; side < 2; ++side) {
        const ProfileShape& own = *sides[static_cast<std::size_t>(side)];
        const Pieces pieces = profile_pieces(own, diagram_steps);
        if (side == 0 || form.is_conjugate()) {
            TurnPanel panel = pressure_panel(pieces, limits);
            if (form.is_conjugate()) panel.caption += ", " + side_name(form, side);
            if (side == 0 && form.is_grooved()) panel.marks = pressure.marks;
            diagram.panels.push_back(std::move(panel));
        }
        diagram.panels.push_back(curvature_panel(own, pieces, limits));
        diagram.panels.back().caption =
            fmt::format("Curvature, {}, 1/ρ (convex > 0, concave < 0)", side_name(form, side));
    }
    return diagram;
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
    if (shape.other)
        return turn_diagram_svg(two_sided(std::move(diagram), std::move(pressure), shape, limits));
    // The pressure angle of a translating flat face is 0 everywhere: nothing to draw.
    if (shape.cam.follower != FollowerType::translating_flat) diagram.panels.push_back(std::move(pressure));
    diagram.panels.push_back(std::move(curvature));
    return turn_diagram_svg(diagram);
}

}  // namespace camopt
