// SPDX-License-Identifier: MIT
#include "report/drawing/plane_cam.hpp"

#include "report/view/cam_words.hpp"

#include <Eigen/Geometry>

#include <set>

namespace camopt {

namespace {

using Eigen::Vector2d;
using units::degree;
using PartKind = MechanismShape::Kind;

constexpr int outline_steps = 1440;  // a quarter of a degree
constexpr double mark_step = 30 * degree, ghost_step = 60 * degree;
constexpr double ghost_length = 0.45, face_margin = 0.12;   // of the size, below
constexpr double guide_begin = 0.6, guide_end = 0.9;        // of a stem
constexpr double arrow_radius = 0.42;                       // of the cam's least
constexpr double travel_arrow = 0.2, travel_height = 0.35;  // of the plate's length and height
constexpr double arrow_begin = 35 * degree, arrow_end = 145 * degree;
constexpr double cross_px = 9, head_px = 9, mark_px = 8, ring_px = 14, joint_px = 3.2, dot_px = 2,
                 pivot_px = 4.5, slider_px = 5, plate_px = 7;

/// What the parts without a dimension are measured by.
double size_of(const ProfileShape& shape) {
    return std::max(shape.base_radius(), shape.roller_radius());
}

template <class Use>
void for_each_angle(const ProfileShape& shape, double step, Use use) {
    const double rounding = 1e-6 * step;
    const bool turn = shape.closed;  // the end is the beginning
    for (double k = std::ceil((shape.begin() - rounding) / step);
         k * step < shape.end() + (turn ? -rounding : rounding); ++k)
        use(std::clamp(k * step, shape.begin(), shape.end()));
}

Vector2d center_of(const ProfileShape& shape) {
    return shape.parts(shape.start).front().points.front();
}

/// The cam angles of the least and the largest output.
std::pair<double, double> ends_of_output(const ProfileShape& shape) {
    std::pair<double, double> ends(shape.start, shape.start);
    for (const std::vector<MechanismPoint>& piece : profile_pieces(shape, outline_steps))
        for (const MechanismPoint& point : piece) {
            const double s = shape.output(point.theta).s;
            if (s < shape.output(ends.first).s) ends.first = point.theta;
            if (s > shape.output(ends.second).s) ends.second = point.theta;
        }
    return ends;
}

std::vector<MechanismShape> turned_back(const ProfileShape& shape, std::vector<MechanismShape> parts,
                                        double theta) {
    for (MechanismShape& part : parts)
        for (Vector2d& point : part.points) point = shape.turned_back(point, theta);
    return parts;
}

/// Pale, at another cam angle and turned back with the cam: what touches it.
void add_follower_ghost(Drawing& drawing, const ProfileShape& shape, double theta,
                        const std::pair<double, double>& reach) {
    const double length = std::max(ghost_length * size_of(shape), 1.2 * shape.roller_radius());
    std::set<PartKind> seen;
    for (MechanismShape& part : turned_back(shape, drawn_parts(shape, theta, reach), theta)) {
        if (!seen.insert(part.kind).second || (part.kind == PartKind::link && shape.has_face())) continue;
        if (part.kind == PartKind::circle) drawing.circle("ghost", part.points.front(), part.radius);
        if (part.kind != PartKind::link && part.kind != PartKind::face) continue;
        const Vector2d along = (part.points.back() - part.points.front()).normalized();
        if (part.kind == PartKind::link) part.points.back() = part.points.front() + length * along;
        if (part.kind == PartKind::face && !(shape.has_pushed_face() && shape.face_half_width)) {
            const Vector2d contact = in_plane(shape.at(theta).contact);
            part.points = {contact - length * along, contact + length * along};
        }
        drawing.polyline("ghost", part.points);
    }
}

/// Pale, the links and the roller at another cam angle.
void add_linkage_ghost(Drawing& drawing, const ProfileShape& shape, double theta) {
    for (const MechanismShape& part : placed_parts(shape, theta, shape.start)) {
        if (part.kind == PartKind::circle) drawing.circle("ghost", part.points.front(), part.radius);
        if (part.kind == PartKind::link) drawing.polyline("ghost", part.points);
    }
}

/// Both walls as one area, and the roller where the motion begins and ends.
void add_guide(Drawing& drawing, const ProfileShape& shape) {
    std::vector<ArcVertex> slot;
    for (const DrawnElement& element : drawing.elements)
        if (const auto* path = std::get_if<DrawnPath>(&element); path && path->style == "wall-left")
            slot.insert(slot.end(), path->vertices.begin(), path->vertices.end());
        else if (path && path->style == "wall-right")
            slot.insert(slot.end(), path->vertices.rbegin(), path->vertices.rend());
    drawing.path("slot", std::move(slot), true);
    for (const double theta : {shape.begin(), shape.end()})
        drawing.circle("roller", in_plane(shape.at(theta).pitch), shape.roller_radius());
}

void add_undercut(Drawing& drawing, const ProfileShape& side, const Vector2d& center, double px) {
    for (const std::vector<MechanismPoint>& piece : profile_pieces(side, outline_steps)) {
        std::vector<Vector2d> stretch;
        const auto finish = [&] {
            if (stretch.empty()) return;
            drawing.polyline("undercut", stretch);
            drawing.circle("ring", stretch[stretch.size() / 2], ring_px * px);
            stretch.clear();
        };
        for (const MechanismPoint& point : piece) {
            if (point.regularity <= 0.0)
                stretch.emplace_back(center + in_plane(point.contact));
            else
                finish();
        }
        finish();
    }
}

/// In the middle of a plate, the way that it slides.
void add_travel(Drawing& drawing, const ProfileShape& shape, double px) {
    const Vector2d first = in_plane(shape.at(shape.begin()).contact),
                   last = in_plane(shape.at(shape.end()).contact);
    const Vector2d middle(0.5 * (first.x() + last.x()), travel_height * shape.base_radius());
    const Vector2d way = Vector2d::UnitX() * (first.x() < last.x() ? -1.0 : 1.0);
    const double half = 0.5 * travel_arrow * std::abs(last.x() - first.x());
    const Vector2d tip = middle + half * way, head = head_px * px * way;
    drawing.line("arrow", middle - half * way, tip);
    drawing.polyline("arrow-head",
                     std::array<Vector2d, 3>{tip + head, tip + 0.45 * Vector2d(-head.y(), head.x()),
                                             tip - 0.45 * Vector2d(-head.y(), head.x())},
                     true);
}

/// A cross at the centre, and an arrow in the sense in which the cam turns.
void add_rotation(Drawing& drawing, const ProfileShape& shape, const Vector2d& center, double px) {
    const double sense = sense_of(shape.formulas().rotation()), radius = arrow_radius * shape.base_radius();
    for (const Vector2d& reach : {Vector2d(cross_px * px, 0.0), Vector2d(0.0, cross_px * px)})
        drawing.line("center", center - reach, center + reach);
    const auto out = [](double angle) { return Vector2d(std::cos(angle), std::sin(angle)); };
    const double from = sense > 0.0 ? arrow_begin : arrow_end, to = sense > 0.0 ? arrow_end : arrow_begin;
    drawing.path("arrow", {{center + radius * out(from), std::tan(0.25 * (to - from))},
                           {center + radius * out(to), 0.0}});
    const Vector2d tip = center + radius * out(to), head = head_px * px * out(to);
    drawing.polyline("arrow-head",
                     std::array<Vector2d, 3>{tip + sense * Vector2d(-head.y(), head.x()), tip + 0.45 * head,
                                             tip - 0.45 * head},
                     true);
}

}  // namespace

SideCurve sampled_curve(int count) {
    return [count](const ProfileShape& side, bool of_cam) {
        std::vector<ArcVertex> vertices;
        for (const std::vector<MechanismPoint>& piece : profile_pieces(side, count))
            for (const MechanismPoint& point : piece)
                vertices.push_back({in_plane(of_cam ? point.contact : point.pitch), 0.0});
        return vertices;
    };
}

std::vector<ArcVertex> body_outline(const ProfileShape& shape, std::vector<ArcVertex> surface) {
    if (!shape.is_plate()) return surface;
    const double first = surface.front().position.x(), last = surface.back().position.x();
    surface.push_back({{last, 0.0}, 0.0});
    surface.push_back({{first, 0.0}, 0.0});
    return surface;
}

Drawing cam_outlines(const ProfileShape& shape, const SideCurve& curve) {
    Drawing drawing;
    const bool turns = shape.picture.outline == CamOutline::round,
               slot = shape.picture.outline == CamOutline::slot;
    drawing.path(slot ? "wall-left" : "cam", body_outline(shape, curve(shape, true)),
                 shape.closed || shape.is_plate());
    if (turns) drawing.circle("circle", {0.0, 0.0}, shape.base_radius());
    if (shape.has_roller()) drawing.path("pitch", curve(shape, false), shape.closed);
    if (turns && shape.has_roller()) drawing.circle("prime", {0.0, 0.0}, shape.prime_radius());
    if (shape.other) {
        const ProfileShape other = other_side(shape);
        const char* const style = slot ? "wall-right" : shape.is_grooved() ? "groove" : "second";
        drawing.path(style, curve(other, true), shape.closed);
        if (const std::optional<double> rim = rim_radius(shape)) drawing.circle("rim", {0.0, 0.0}, *rim);
        if (shape.has_two_disks()) drawing.path("second-pitch", curve(other, false), shape.closed);
    }
    if (!shape.closed && !shape.open_because.empty())
        drawing.line("open", in_plane(shape.at(shape.begin()).contact),
                     in_plane(shape.at(shape.end()).contact));
    return drawing;
}

std::string outline_words(const ProfileShape& shape, std::string_view style) {
    const CamMechanism& cam = shape.formulas();
    if (shape.is_plate() && style == "cam") return "plate";
    if (style == "cam" || style == "wall-left")
        return shape.other && !shape.is_grooved() ? cam.station_name(0) : "cam";
    if (style == "second" || style == "wall-right") return cam.station_name(1);
    if (style == "groove") return "groove: inner, outer flank";
    if (style == "rim") return "the grooved disk";
    if (style == "pitch") return "pitch curve (roller centre)";
    if (style == "second-pitch") return "pitch curve of the second disk";
    if (style == "circle") return "base circle";
    return style == "prime" ? "prime circle" : "open: not given";
}

std::pair<double, double> reach_of_face(const ProfileShape& shape) {
    if (shape.has_pushed_face() && shape.face_half_width)
        return {-*shape.face_half_width, *shape.face_half_width};
    std::pair<double, double> reach(0.0, 0.0);
    if (!shape.has_face()) return reach;
    for (const std::vector<MechanismPoint>& piece : profile_pieces(shape, outline_steps))
        for (const MechanismPoint& point : piece) {
            reach.first = std::min(reach.first, point.contact_offset);
            reach.second = std::max(reach.second, point.contact_offset);
        }
    const double beyond = face_margin * size_of(shape);
    return {std::min(reach.first - beyond, 0.0), reach.second + beyond};
}

std::vector<MechanismShape> drawn_parts(const ProfileShape& shape, double theta,
                                        const std::pair<double, double>& reach) {
    std::vector<MechanismShape> parts = shape.parts(theta);
    for (MechanismShape& part : parts)
        if (part.kind == PartKind::face) {
            const Vector2d along = part.points[1] - part.points[0];
            part.points = {part.points[0] + reach.first * along, part.points[0] + reach.second * along};
        }
    return parts;
}

std::vector<MechanismShape> placed_parts(const ProfileShape& shape, double theta, double back) {
    return turned_back(shape, shape.parts(theta), back);
}

void add_mechanism(Drawing& drawing, const ProfileShape& shape) {
    if (shape.picture.outline == CamOutline::slot) return add_guide(drawing, shape);
    drawing.move(center_of(shape));
    const std::pair<double, double> reach = reach_of_face(shape), ends = ends_of_output(shape);
    const bool direct = shape.direct.has_value();
    if (direct)
        for_each_angle(shape, ghost_step, [&](double theta) {
            if (std::abs(theta - shape.start) > 1e-9) add_follower_ghost(drawing, shape, theta, reach);
        });
    else
        for (const double theta : {ends.first, ends.second}) add_linkage_ghost(drawing, shape, theta);
    const std::vector<MechanismShape> low = placed_parts(shape, ends.first, shape.start),
                                      high = placed_parts(shape, ends.second, shape.start);
    std::vector<Vector2d> link;
    std::size_t i = 0;
    for (const MechanismShape& part :
         turned_back(shape, drawn_parts(shape, shape.start, reach), shape.start)) {
        if (part.kind == PartKind::link) drawing.polyline("link", link = part.points);
        if (part.kind == PartKind::face) drawing.polyline("face", part.points);
        if (part.kind == PartKind::circle) drawing.circle("roller", part.points.front(), part.radius);
        if (part.kind == PartKind::guide && direct)  // around the stem
            drawing.line("guide", link[0] + guide_begin * (link[1] - link[0]),
                         link[0] + guide_end * (link[1] - link[0]));
        else if (part.kind == PartKind::guide)
            drawing.line("guide", low[i].points.back(), high[i].points.back());
        ++i;
    }
}

std::vector<AngleMark> angle_marks(const ProfileShape& shape) {
    std::vector<AngleMark> marks;
    for_each_angle(shape, mark_step, [&](double theta) {
        const MechanismPoint point = shape.at(theta);
        marks.push_back({theta, center_of(shape) + in_plane(point.contact), -in_plane(point.normal)});
    });
    return marks;
}

void add_marks(Drawing& drawing, const ProfileShape& shape, double px) {
    const Vector2d center = center_of(shape);
    const auto pin = [&](const char* style, const Vector2d& at, double radius) {
        drawing.circle(style, at, radius * px);
    };
    const auto stand = [&](const Vector2d& at) {
        drawing.polyline("ground",
                         std::array<Vector2d, 3>{at, at + 2.4 * pivot_px * px * Vector2d(-0.8, -1.2),
                                                 at + 2.4 * pivot_px * px * Vector2d(0.8, -1.2)},
                         true);
        pin("pivot", at, pivot_px);
    };
    if (shape.picture.outline == CamOutline::slot) return stand(center);
    add_undercut(drawing, shape, center, px);
    if (shape.other) add_undercut(drawing, other_side(shape), center, px);
    for (const AngleMark& mark : angle_marks(shape))
        drawing.line("mark", mark.at, mark.at + mark_px * px * mark.inwards);
    if (shape.is_plate())
        add_travel(drawing, shape, px);
    else
        add_rotation(drawing, shape, center, px);
    for (const MechanismShape& part :
         turned_back(shape, drawn_parts(shape, shape.start, reach_of_face(shape)), shape.start)) {
        const Vector2d first = part.points.front(), last = part.points.back();
        if (part.kind == PartKind::link)
            for (const Vector2d& point : part.points) pin("joint", point, joint_px);
        if (part.kind == PartKind::circle) pin("dot", first, dot_px);
        if (part.kind == PartKind::guide && !shape.direct) pin("slider", last, slider_px);
        if (part.kind == PartKind::pivot && (first - center).norm() > px) stand(first);
        if (part.kind == PartKind::face) {  // the plate lies away from the cam
            Vector2d up = plate_px * px * Vector2d(first.y() - last.y(), last.x() - first.x()).normalized();
            if (up.dot(first - center) < 0.0) up = -up;
            drawing.polyline("plate", std::array<Vector2d, 4>{first, last, last + up, first + up}, true);
        }
    }
}

}  // namespace camopt
