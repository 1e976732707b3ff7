// SPDX-License-Identifier: MIT
#include "shop/disk/disk_solid.hpp"

#include "report/drawing/plane_cam.hpp"
#include "report/surface/mesh_cut.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "shop/sheet/cam_sheet.hpp"

#include <fmt/format.h>

#include <map>

namespace camopt {

namespace {

using Eigen::Vector2d;
using Polygon = std::vector<Vector2d>;

constexpr double curve_tolerance = 1e-8;  // m
constexpr double same_radius = 1e-12;     // of the radius: a dwell
constexpr int first_points = 9, most_points = 4097, dwell_samples = 8;
constexpr int least_points = 16;

double thickness_of(const DrawingSpec& drawing) {
    const double thickness = drawing.thickness.value_or(default_thickness);
    if (!(std::isfinite(thickness) && thickness > 0.0))
        throw InputError(fmt::format("plane cam: the thickness must be > 0 m, found {:g}", thickness));
    return thickness;
}

double groove_depth_of(const DrawingSpec& drawing) {
    const double thickness = thickness_of(drawing), depth = drawing.groove_depth.value_or(0.5 * thickness);
    if (!(depth > 0.0 && depth < thickness))
        throw InputError(
            fmt::format("drawing.groove_depth: found {:.6g} mm; allowed: more than 0 and less than the "
                        "thickness, {:.6g} mm",
                        millimetres_shown.of(depth), millimetres_shown.of(thickness)));
    return depth;
}

void check_solid(const ProfileShape& shape, const DrawingSpec& drawing) {
    check_can_be_made(shape);
    static_cast<void>(thickness_of(drawing));
    if (drawing.bore && !(drawing.reach() > 0.0 && drawing.reach() < least_radius(shape)))
        throw InputError(
            fmt::format("plane cam: found a bore or keyway that reaches {:.6g} mm from the centre; allowed: "
                        "less than {:.6g} mm, the cam's least radius",
                        millimetres_shown.of(drawing.reach()), millimetres_shown.of(least_radius(shape))));
}

/// Corners on the arcs, chords within the tolerance.
Polygon polygon_within(const std::vector<ArcVertex>& vertices, double tolerance) {
    Polygon polygon;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vector2d &from = vertices[i].position, &to = vertices[(i + 1) % vertices.size()].position;
        polygon.push_back(from);
        if (std::abs(vertices[i].bulge) < 1e-9) continue;
        const BulgeArc arc = bulge_arc(from, to, vertices[i].bulge);
        const double step = 2.0 * std::acos(std::max(-1.0, 1.0 - tolerance / arc.radius));
        const int count = static_cast<int>(std::ceil(std::abs(arc.to - arc.from) / step));
        for (int k = 1; k < count; ++k) {
            const double angle = arc.from + (arc.to - arc.from) * k / count;
            polygon.emplace_back(arc.center + arc.radius * Vector2d(std::cos(angle), std::sin(angle)));
        }
    }
    return polygon;
}

Polygon to_the_left(Polygon polygon) {
    if (polygon_area(polygon) < 0.0) std::ranges::reverse(polygon);
    return polygon;
}

/// Every line of a plate's boundary at its heights once. Lines turn to the left.
class PlateMesh {
 public:
    explicit PlateMesh(const PlateOf<Polygon>& plate) {
        const double bottom = -plate.thickness;
        if (plate.groove) {
            const auto& [outer, inner, depth] = *plate.groove;
            add_faces(plate.outline, outer, {{0.0, true}});
            add_faces(outer, inner, {{-depth, true}});
            add_faces(inner, plate.hole, {{0.0, true}});
            add_faces(plate.outline, plate.hole, {{bottom, false}});
            add_wall(outer, -depth, false);
            add_wall(inner, -depth, true);
        } else {
            add_faces(plate.outline, plate.hole, {{0.0, true}, {bottom, false}});
        }
        add_wall(plate.outline, bottom, true);
        add_wall(plate.hole, bottom, false);
    }
    [[nodiscard]] TriangleMesh mesh() && { return std::move(mesh_); }

 private:
    struct Level {
        double z;
        bool upwards;
    };
    TriangleMesh mesh_;
    std::map<std::pair<const Polygon*, double>, int> first_;  // vertex of a line at a height

    int first_of(const Polygon& line, double z) {
        const auto [place, is_new] = first_.try_emplace({&line, z}, static_cast<int>(mesh_.vertices.size()));
        if (is_new)
            for (const Vector2d& point : line) mesh_.vertices.emplace_back(point.x(), point.y(), z);
        return place->second;
    }
    void add_faces(const Polygon& outline, const Polygon& hole, std::initializer_list<Level> levels) {
        const std::vector<std::array<int, 3>> triangles = plane_triangles(outline, hole);
        const int corners = static_cast<int>(outline.size());
        for (const Level& level : levels) {
            const int first = first_of(outline, level.z), second = first_of(hole, level.z) - corners;
            const auto vertex = [&](int i) { return i + (i < corners ? first : second); };
            for (const std::array<int, 3>& t : triangles)
                add(vertex(t[0]), vertex(t[1]), vertex(t[2]), level.upwards);
        }
    }
    /// From the upper face down. outside: the plate lies within it.
    void add_wall(const Polygon& line, double bottom, bool outside) {
        const int upper = first_of(line, 0.0), lower = first_of(line, bottom),
                  count = static_cast<int>(line.size());
        for (int i = 0; i < count; ++i) {
            const int next = (i + 1) % count;
            add(upper + i, lower + i, lower + next, outside);
            add(upper + i, lower + next, upper + next, outside);
        }
    }
    void add(int a, int b, int c, bool forwards) {
        mesh_.triangles.push_back(forwards ? std::array{a, b, c} : std::array{a, c, b});
    }
};

/// The largest distance of the outline from the polygon: from points between its corners, along their
/// normals.
double sagitta(const ProfileShape& shape, int count) {
    double worst = 0.0;
    const double step = (shape.end() - shape.begin()) / count;
    for (int k = 0; k < count; ++k) {
        const Vector2d from = in_plane(shape.at(shape.begin() + step * k).contact),
                       to = in_plane(shape.at(std::min(shape.begin() + step * (k + 1), shape.end())).contact);
        const Vector2d chord = (to - from).normalized();
        for (const double part : {0.25, 0.5, 0.75}) {
            const Vector2d out = in_plane(shape.at(shape.begin() + step * (k + part)).contact) - from;
            worst = std::max(worst, std::abs(chord.x() * out.y() - chord.y() * out.x()));
        }
    }
    return worst;
}

/// Turns to the left; `deviation` grows to the largest distance from the contour.
Polygon contour_polygon(const ProfileShape& shape, const DiskMeshOptions& options, double& deviation) {
    if (options.points) {
        if (*options.points < least_points)
            throw InputError(fmt::format("plane cam: there must be {} points or more, found {}", least_points,
                                         *options.points));
        deviation = std::max(deviation, sagitta(shape, *options.points));
        std::vector<ArcVertex> surface;
        for (const Vector2d& point : contour_points(shape, *options.points)) surface.push_back({point, 0.0});
        if (shape.is_plate()) surface.push_back({in_plane(shape.at(shape.end()).contact), 0.0});
        Polygon polygon;
        for (const ArcVertex& vertex : body_outline(shape, std::move(surface)))
            polygon.push_back(vertex.position);
        return to_the_left(std::move(polygon));
    }
    // The arcs take a tenth of the tolerance, their chords the rest.
    deviation = std::max(deviation, options.chord_tolerance);
    const ArcChain chain = outline_chain(shape, true, 0.1 * options.chord_tolerance);
    return to_the_left(polygon_within(body_outline(shape, chain.vertices), 0.9 * options.chord_tolerance));
}

/// An arc about the cam's centre, of a plate a line along its travel.
bool is_dwell(const ProfileShape& shape, double begin, double end) {
    const auto height = [&](double theta) {
        const Vector2d point = in_plane(shape.at(theta).contact);
        return shape.is_plate() ? point.y() : point.norm();
    };
    const double first = height(begin);
    for (int i = 1; i < dwell_samples; ++i)
        if (std::abs(height(begin + (end - begin) * i / dwell_samples) - first) > same_radius * first)
            return false;
    return true;
}

PlateEdge curve_through(const ProfileShape& shape, double begin, double end) {
    for (int count = first_points;; count = 2 * count - 1) {
        SurfaceGrid grid;
        grid.name = "outline";
        grid.v = {0.0, 1.0};
        for (int i = 0; i < count; ++i) grid.u.push_back(begin + (end - begin) * i / (count - 1));
        for (const double height : grid.v)
            for (const double theta : grid.u) {
                const Vector2d point = in_plane(shape.at(theta).contact);
                grid.points.emplace_back(point.x(), point.y(), height);
            }
        const BsplineSurface surface = bspline_surfaces(grid).front();
        double worst = 0.0;
        for (int i = 0; i + 1 < count; ++i) {
            const double theta = 0.5 * (grid.u[i] + grid.u[static_cast<std::size_t>(i) + 1]);
            const MechanismPoint point = shape.at(theta);
            const Vector2d gap = surface.at(theta, 0.0).head<2>() - in_plane(point.contact);
            worst = std::max(worst, std::abs(gap.dot(in_plane(point.normal))));
        }
        if (worst > curve_tolerance && count < most_points) continue;
        PlateEdge edge;
        edge.kind = PlateEdge::Kind::curve;
        edge.knots = surface.knots_u;
        for (std::size_t i = 0; i < surface.columns(); ++i)
            edge.poles.emplace_back(surface.poles[i].head<2>());
        return edge;
    }
}

/// Dwells as arcs or lines, all else as curves.
std::vector<PlateEdge> contour_edges(const ProfileShape& shape) {
    std::vector<PlateEdge> outline;
    for (std::size_t i = 0; i + 1 < shape.knots.size(); ++i) {
        const double begin = shape.knots[i], end = shape.knots[i + 1];
        PlateEdge edge;
        if (!is_dwell(shape, begin, end)) {
            edge = curve_through(shape, begin, end);
        } else if (!shape.is_plate()) {
            edge.kind = PlateEdge::Kind::arc;
            edge.middle = in_plane(shape.at(0.5 * (begin + end)).contact);
        }
        edge.from = i == 0 ? in_plane(shape.at(begin).contact) : outline.back().to;
        edge.to = i + 2 < shape.knots.size() || shape.is_plate() ? in_plane(shape.at(end).contact)
                  : outline.empty()                              ? edge.from
                                                                 : outline.front().from;
        if (!edge.poles.empty()) {
            edge.poles.front() = edge.from;
            edge.poles.back() = edge.to;
        }
        outline.push_back(std::move(edge));
    }
    if (!shape.is_plate()) return outline;
    const std::vector<ArcVertex> around =
        body_outline(shape, {{outline.front().from, 0.0}, {outline.back().to, 0.0}});
    for (std::size_t i = 1; i < around.size(); ++i) {
        PlateEdge side;
        side.from = around[i].position;
        side.to = around[(i + 1) % around.size()].position;
        outline.push_back(side);
    }
    return outline;
}

std::vector<PlateEdge> edges_of(const std::vector<ArcVertex>& vertices) {
    std::vector<PlateEdge> edges;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        PlateEdge edge;
        edge.from = vertices[i].position;
        edge.to = vertices[(i + 1) % vertices.size()].position;
        if (vertices[i].bulge != 0.0) {
            edge.kind = PlateEdge::Kind::arc;
            const BulgeArc arc = bulge_arc(edge.from, edge.to, vertices[i].bulge);
            const double middle = 0.5 * (arc.from + arc.to);
            edge.middle = arc.center + arc.radius * Vector2d(std::cos(middle), std::sin(middle));
        }
        edges.push_back(edge);
    }
    return edges;
}

/// `contour`: the line of a side of the cam; `joined`: of lines and arcs.
template <class Contour, class Joined>
auto plate_of(const ProfileShape& shape, const DrawingSpec& drawing, Contour contour, Joined joined) {
    check_solid(shape, drawing);
    PlateOf<std::decay_t<decltype(contour(shape))>> plate;
    plate.thickness = thickness_of(drawing);
    plate.outline = shape.other ? joined(rim_outline(shape)) : contour(shape);
    if (shape.other) plate.groove = {contour(other_side(shape)), contour(shape), groove_depth_of(drawing)};
    if (drawing.bore) plate.hole = joined(bore_outline(drawing, shape.formulas().rotation()));
    return plate;
}

}  // namespace

std::vector<Vector2d> contour_points(const ProfileShape& shape, int count) {
    std::vector<Vector2d> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k)
        points.push_back(
            in_plane(shape.at(shape.begin() + (shape.end() - shape.begin()) * k / count).contact));
    return points;
}

void check_can_be_made(const ProfileShape& shape) {
    if (!shape.closed && !shape.is_plate())
        throw InputError(fmt::format(
            "plane cam: found an open one{}; allowed: a cam of one revolution (motion.type \"RR\" or a "
            "program that returns to displacement 0), to be milled or made a solid",
            shape.open_because.empty() ? "" : " (" + shape.open_because + ")"));
    if (shape.has_two_disks())
        throw InputError("plane cam: found two disks; allowed: one of them (made_pieces)");
    const auto undercut = [](const ProfileShape& side) {
        return !cusp_angles(side).empty() || !(side.at(side.begin()).regularity > 0.0);
    };
    if (undercut(shape) || (shape.other && undercut(other_side(shape))))
        throw InputError(
            "plane cam: found an undercut one, whose outline intersects itself; allowed: a cam that guides "
            "its follower everywhere (limits.cam_radius_min = 0)");
}

double disk_volume(const ProfileShape& shape, const DrawingSpec& drawing) {
    check_solid(shape, drawing);
    DrawingSpec complete = drawing;
    complete.thickness = thickness_of(drawing);
    if (shape.other) complete.groove_depth = groove_depth_of(drawing);
    return cam_volume(shape, complete);
}

DiskMesh disk_mesh(const ProfileShape& shape, const DrawingSpec& drawing, const DiskMeshOptions& options) {
    if (!(options.chord_tolerance > 0.0))
        throw InputError(
            fmt::format("plane cam: the chord tolerance must be > 0 m, found {:g}", options.chord_tolerance));
    DiskMesh result;
    const PlateOf<Polygon> plate = plate_of(
        shape, drawing,
        [&](const ProfileShape& side) { return contour_polygon(side, options, result.deviation); },
        [&](const std::vector<ArcVertex>& arcs) { return polygon_within(arcs, options.chord_tolerance); });
    result.mesh = PlateMesh(plate).mesh();
    result.volume = volume(result.mesh);
    result.exact = disk_volume(shape, drawing);
    return result;
}

Plate disk_plate(const ProfileShape& shape, const DrawingSpec& drawing, const std::string& name) {
    const TitleBlock& title = drawing.title_block;
    return {plate_of(shape, drawing, contour_edges, edges_of), title.part.empty() ? name : title.part,
            title.drawn_by, title.organisation};
}

}  // namespace camopt
