// SPDX-License-Identifier: MIT
// What of a disk cam a drawing measures.
#include "report/drawing/plane_cam.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "shop/sheet/cam_sheet.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr int radius_samples = 1440, radius_bisections = 60;
constexpr double through_an_end = 1e-9;  // rad
constexpr double area_tolerance = 1e-8;  // m

double side_of(const Vector2d& ray, const Vector2d& point) {
    return ray.x() * point.y() - ray.y() * point.x();
}

Vector2d point_of(const MechanismPoint& point, bool of_cam) {
    return in_plane(of_cam ? point.contact : point.pitch);
}

/// 0.5 ∮ (x dy − y dx), its arcs exact: the segment beyond a chord of length c with the bulge b, angle φ = 4
/// atan b, radius r has the area r² (φ − sin φ) / 2.
double area_of(const std::vector<ArcVertex>& vertices) {
    double corners = 0.0, segments = 0.0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vector2d &from = vertices[i].position, &to = vertices[(i + 1) % vertices.size()].position;
        corners += 0.5 * side_of(from, to);
        const double angle = 4.0 * std::atan(vertices[i].bulge);
        const double chord = (to - from).norm();
        if (std::abs(angle) < 1e-4) {  // r²(φ − sin φ)/2 → c² φ/12
            segments += chord * chord * angle / 12.0;
            continue;
        }
        const double radius = 0.5 * chord / std::sin(0.5 * angle);
        segments += 0.5 * radius * radius * (angle - std::sin(angle));
    }
    return std::abs(corners + segments);
}

}  // namespace

Vector2d ray_at(Rotation rotation, double cam_angle) {
    const double turn = sense_of(rotation) * cam_angle;
    return {std::sin(turn), std::cos(turn)};
}

std::optional<double> radius_along(const ProfileShape& shape, const Vector2d& ray, bool of_cam) {
    std::optional<double> outermost;
    const auto crossing_between = [&](double left, double right, bool above_first) {
        for (int i = 0; i < radius_bisections; ++i) {
            const double middle = 0.5 * (left + right);
            const bool here = side_of(ray, point_of(shape.at(middle), of_cam)) > 0.0;
            (here == above_first ? left : right) = middle;
        }
        return 0.5 * (left + right);
    };
    const auto take = [&](double theta) {
        const double along = ray.dot(point_of(shape.at(theta), of_cam));
        if (along > 0.0 && (!outermost || along > *outermost)) outermost = along;
    };
    // Over the joints of pieces too: a ray may pass through a knot.
    std::optional<MechanismPoint> last;
    for (const std::vector<MechanismPoint>& piece : profile_pieces(shape, radius_samples))
        for (const MechanismPoint& point : piece) {
            const double after = side_of(ray, point_of(point, of_cam));
            if (last) {
                const double before = side_of(ray, point_of(*last, of_cam));
                if ((before > 0.0) != (after > 0.0))
                    take(crossing_between(last->theta, point.theta, before > 0.0));
            }
            last = point;
        }
    // Where the end is the beginning, a ray may pass between the two.
    for (const double theta : {shape.begin(), shape.end()})
        if (const Vector2d end = point_of(shape.at(theta), of_cam);
            std::abs(side_of(ray, end)) < through_an_end * end.norm())
            take(theta);
    return outermost;
}

double least_radius(const ProfileShape& shape) {
    double least = shape.at(shape.begin()).contact.norm();
    for (const std::vector<MechanismPoint>& piece : profile_pieces(shape, radius_samples))
        for (const MechanismPoint& point : piece) least = std::min(least, point.contact.norm());
    return least;
}

DrawingSpec drawing_of(const Solution& solution, const ProfileShape& shape, const CamSheetOptions& options) {
    DrawingSpec drawing = solution.scene.drawing.value_or(DrawingSpec{});
    if (options.bore) drawing.bore = options.bore;
    if (options.thickness) drawing.thickness = options.thickness;
    if (!drawing.thickness) drawing.thickness = default_thickness;
    if (shape.is_grooved() && !drawing.groove_depth) drawing.groove_depth = 0.5 * *drawing.thickness;
    if (shape.is_plate()) {
        if (!drawing.bore) return drawing;
        throw InputError(
            "drawing.bore: found a bore in a plate that slides; allowed: none, it is held by its sides");
    }
    const double least = least_radius(shape);
    const ShownUnit shown = shown_units(solution.scene).length;
    if (drawing.keyway && drawing.bore && !(drawing.keyway->width < *drawing.bore))
        throw InputError(fmt::format("drawing.keyway.width: found {}; allowed: less than the bore's {}",
                                     shown.text(drawing.keyway->width), shown.text(*drawing.bore)));
    if (drawing.groove_depth && !(*drawing.groove_depth < *drawing.thickness))
        throw InputError(fmt::format("drawing.groove_depth: found {}; allowed: less than the thickness, {}",
                                     shown.text(*drawing.groove_depth), shown.text(*drawing.thickness)));
    if (!(drawing.reach() < least))
        throw InputError(
            fmt::format("drawing.{}: found {} from the centre; allowed: less than {}, the least radius of "
                        "the cam",
                        drawing.keyway ? "keyway" : "bore", shown.text(drawing.reach()), shown.text(least)));
    return drawing;
}

std::vector<ArcVertex> bore_outline(const DrawingSpec& drawing, Rotation rotation) {
    const double radius = 0.5 * drawing.bore.value();
    if (!drawing.keyway) return {{{radius, 0.0}, 1.0}, {{-radius, 0.0}, 1.0}};
    const Keyway& keyway = *drawing.keyway;
    const double half = 0.5 * keyway.width, edge = std::sqrt(radius * radius - half * half),
                 floor = radius + keyway.depth, angle = std::atan2(half, edge);
    const Vector2d out = ray_at(rotation, keyway.at), left(-out.y(), out.x());
    const auto at = [&](double along, double across) -> Vector2d { return along * out + across * left; };
    // From the left edge around the bore to the right edge, then around the slot.
    const double half_turn = 0.5 * (units::turn - 2.0 * angle);
    const double bulge = std::tan(0.25 * half_turn);
    return {{at(edge, half), bulge},
            {at(-radius, 0.0), bulge},
            {at(edge, -half), 0.0},
            {at(floor, -half), 0.0},
            {at(floor, half), 0.0}};
}

std::vector<ArcVertex> rim_outline(const ProfileShape& shape) {
    const double radius = rim_radius(shape).value();
    return {{{radius, 0.0}, 1.0}, {{-radius, 0.0}, 1.0}};
}

double cam_volume(const ProfileShape& shape, const DrawingSpec& drawing) {
    const double bore = drawing.bore ? area_of(bore_outline(drawing, shape.formulas().rotation())) : 0.0;
    const auto area = [](const ProfileShape& side) {
        return area_of(body_outline(side, outline_chain(side, true, area_tolerance).vertices));
    };
    const double thickness = drawing.thickness.value();
    if (!shape.other) return (area(shape) - bore) * thickness;
    return (area_of(rim_outline(shape)) - bore) * thickness -
           (area(other_side(shape)) - area(shape)) * drawing.groove_depth.value();
}

}  // namespace camopt
