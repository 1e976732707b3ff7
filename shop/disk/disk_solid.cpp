// SPDX-License-Identifier: MIT
#include "shop/disk/disk_solid.hpp"

#include "report/surface/mesh_cut.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "shop/sheet/cam_sheet.hpp"

#include <fmt/format.h>

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
    check_closed(shape);
    static_cast<void>(thickness_of(drawing));
    if (shape.has_two_disks())
        throw InputError("plane cam: found two disks; allowed: one of them (made_pieces)");
    const auto undercut = [](const ProfileShape& side) {
        return !cusp_angles(side).empty() || !(side.at(side.begin()).regularity > 0.0);
    };
    if (undercut(shape) || (shape.other && undercut(other_side(shape))))
        throw InputError(
            "plane cam: found an undercut one, whose outline intersects itself; allowed: a cam that guides "
            "its follower everywhere (limits.cam_radius_min = 0)");
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

void add_wall(TriangleMesh& mesh, int first, int count, int below, bool outside) {
    for (int i = 0; i < count; ++i) {
        const int a = first + i, b = first + (i + 1) % count;
        if (outside) {
            mesh.triangles.push_back({a, a + below, b + below});
            mesh.triangles.push_back({a, b + below, b});
        } else {
            mesh.triangles.push_back({a, b + below, a + below});
            mesh.triangles.push_back({a, b, b + below});
        }
    }
}

TriangleMesh plate_mesh(const Polygon& outline, const Polygon& hole, double thickness) {
    TriangleMesh mesh;
    const int below = static_cast<int>(outline.size() + hole.size());
    for (const double z : {0.0, -thickness})
        for (const Polygon* line : {&outline, &hole})
            for (const Vector2d& point : *line) mesh.vertices.emplace_back(point.x(), point.y(), z);
    for (const std::array<int, 3>& t : plane_triangles(outline, hole)) {
        mesh.triangles.push_back(t);
        mesh.triangles.push_back({t[0] + below, t[2] + below, t[1] + below});
    }
    add_wall(mesh, 0, static_cast<int>(outline.size()), below, true);
    add_wall(mesh, static_cast<int>(outline.size()), static_cast<int>(hole.size()), below, false);
    return mesh;
}

/// Lines of a grooved disk from outside to inside; all turn to the left. The hole may be empty.
struct GroovedLines {
    const Polygon &rim, &outer, &inner, &hole;
};

/// Every line at its heights once: the upper face on either side of the groove, its floor, the lower face.
TriangleMesh grooved_mesh(const GroovedLines& lines, double thickness, double depth) {
    TriangleMesh mesh;
    const auto add = [&](const Polygon& line, double z) {
        const int first = static_cast<int>(mesh.vertices.size());
        for (const Vector2d& point : line) mesh.vertices.emplace_back(point.x(), point.y(), z);
        return first;
    };
    const auto cap = [&](const Polygon& outline, int first, const Polygon& hole, int second, bool upwards) {
        const int corners = static_cast<int>(outline.size());
        const auto vertex = [&](int i) { return i < corners ? first + i : second + i - corners; };
        for (const std::array<int, 3>& t : plane_triangles(outline, hole))
            mesh.triangles.push_back(upwards ? std::array{vertex(t[0]), vertex(t[1]), vertex(t[2])}
                                             : std::array{vertex(t[0]), vertex(t[2]), vertex(t[1])});
    };
    const auto wall = [&](const Polygon& line, int upper, int lower, bool outside) {
        add_wall(mesh, upper, static_cast<int>(line.size()), lower - upper, outside);
    };
    const int rim = add(lines.rim, 0.0), rim_below = add(lines.rim, -thickness);
    const int outer = add(lines.outer, 0.0), outer_floor = add(lines.outer, -depth);
    const int inner = add(lines.inner, 0.0), inner_floor = add(lines.inner, -depth);
    const int hole = add(lines.hole, 0.0), hole_below = add(lines.hole, -thickness);
    cap(lines.rim, rim, lines.outer, outer, true);
    cap(lines.outer, outer_floor, lines.inner, inner_floor, true);
    cap(lines.inner, inner, lines.hole, hole, true);
    cap(lines.rim, rim_below, lines.hole, hole_below, false);
    wall(lines.rim, rim, rim_below, true);
    wall(lines.outer, outer, outer_floor, false);
    wall(lines.inner, inner, inner_floor, true);
    wall(lines.hole, hole, hole_below, false);
    return mesh;
}

Polygon even_polygon(const ProfileShape& shape, int count) {
    if (count < least_points)
        throw InputError(
            fmt::format("plane cam: there must be {} points or more, found {}", least_points, count));
    Polygon polygon;
    polygon.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k)
        polygon.push_back(
            in_plane(shape.at(shape.begin() + (shape.end() - shape.begin()) * k / count).contact));
    return polygon;
}

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
        deviation = std::max(deviation, sagitta(shape, *options.points));
        return to_the_left(even_polygon(shape, *options.points));
    }
    // The arcs take a tenth of the tolerance, their chords the rest.
    deviation = std::max(deviation, options.chord_tolerance);
    const ArcChain chain = outline_chain(shape, true, 0.1 * options.chord_tolerance);
    return to_the_left(polygon_within(chain.vertices, 0.9 * options.chord_tolerance));
}

bool is_dwell(const ProfileShape& shape, double begin, double end) {
    const double radius = shape.at(begin).contact.norm();
    for (int i = 1; i < dwell_samples; ++i) {
        const Vector2d point = in_plane(shape.at(begin + (end - begin) * i / dwell_samples).contact);
        if (std::abs(point.norm() - radius) > same_radius * radius) return false;
    }
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

/// Dwells as arcs, all else as curves.
std::vector<PlateEdge> contour_edges(const ProfileShape& shape) {
    std::vector<PlateEdge> outline;
    for (std::size_t i = 0; i + 1 < shape.knots.size(); ++i) {
        const double begin = shape.knots[i], end = shape.knots[i + 1];
        PlateEdge edge;
        if (is_dwell(shape, begin, end)) {
            edge.kind = PlateEdge::Kind::arc;
            edge.middle = in_plane(shape.at(0.5 * (begin + end)).contact);
        } else {
            edge = curve_through(shape, begin, end);
        }
        edge.from = i == 0 ? in_plane(shape.at(begin).contact) : outline.back().to;
        edge.to = i + 2 < shape.knots.size() ? in_plane(shape.at(end).contact)
                  : outline.empty()          ? edge.from
                                             : outline.front().from;
        if (!edge.poles.empty()) {
            edge.poles.front() = edge.from;
            edge.poles.back() = edge.to;
        }
        outline.push_back(std::move(edge));
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

}  // namespace

void check_closed(const ProfileShape& shape) {
    if (shape.closed) return;
    throw InputError(fmt::format(
        "plane cam: found an open one{}; allowed: a cam of one revolution (motion.type \"RR\" or a "
        "program that returns to displacement 0), to be milled or made a solid",
        shape.open_because.empty() ? "" : " (" + shape.open_because + ")"));
}

double disk_volume(const ProfileShape& shape, const DrawingSpec& drawing) {
    check_solid(shape, drawing);
    DrawingSpec complete = drawing;
    complete.thickness = thickness_of(drawing);
    if (shape.other) complete.groove_depth = groove_depth_of(drawing);
    return cam_volume(shape, complete);
}

DiskMesh disk_mesh(const ProfileShape& shape, const DrawingSpec& drawing, const DiskMeshOptions& options) {
    check_solid(shape, drawing);
    if (!(options.chord_tolerance > 0.0))
        throw InputError(
            fmt::format("plane cam: the chord tolerance must be > 0 m, found {:g}", options.chord_tolerance));
    DiskMesh result;
    Polygon hole;
    const Polygon outline = contour_polygon(shape, options, result.deviation);
    if (drawing.bore)
        hole = polygon_within(bore_outline(drawing, shape.formulas().rotation()), options.chord_tolerance);
    if (shape.other) {
        const Polygon outer = contour_polygon(other_side(shape), options, result.deviation);
        const Polygon rim = polygon_within(rim_outline(shape), options.chord_tolerance);
        result.mesh =
            grooved_mesh({rim, outer, outline, hole}, thickness_of(drawing), groove_depth_of(drawing));
    } else {
        result.mesh = plate_mesh(outline, hole, thickness_of(drawing));
    }
    result.volume = volume(result.mesh);
    result.exact = disk_volume(shape, drawing);
    return result;
}

Plate disk_plate(const ProfileShape& shape, const DrawingSpec& drawing, const std::string& name) {
    check_solid(shape, drawing);
    Plate plate;
    plate.name = name;
    plate.thickness = thickness_of(drawing);
    plate.author = drawing.title_block.drawn_by;
    plate.organisation = drawing.title_block.organisation;
    if (!drawing.title_block.part.empty()) plate.name = drawing.title_block.part;
    if (shape.other) {
        plate.outline = edges_of(rim_outline(shape));
        plate.groove =
            PlateGroove{contour_edges(other_side(shape)), contour_edges(shape), groove_depth_of(drawing)};
    } else {
        plate.outline = contour_edges(shape);
    }
    if (drawing.bore) plate.hole = edges_of(bore_outline(drawing, shape.formulas().rotation()));
    return plate;
}

}  // namespace camopt
