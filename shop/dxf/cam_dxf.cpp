// SPDX-License-Identifier: MIT
#include "shop/dxf/cam_dxf.hpp"

#include "core/version.hpp"
#include "report/cam/cam_files.hpp"
#include "report/drawing/plane_cam.hpp"
#include "report/json/json_text.hpp"
#include "shop/dxf/dxf_drawing.hpp"

#include <set>

namespace camopt {

namespace {

using Eigen::Vector2d;
using PartKind = MechanismShape::Kind;

constexpr double pivot_size = 0.05, opening_text = 0.05;  // of the base radius

/// Of report/drawing/plane_cam.hpp, and of what is added here.
std::vector<DxfStyle> styles_of(const ProfileShape& shape) {
    using enum DxfLine;
    std::vector<DxfStyle> styles = {{"cam", shape.is_grooved() ? "INNER_FLANK" : "CAM"},
                                    {"wall-left", "WALLS"},
                                    {"wall-right", "WALLS"},
                                    {"pitch", "PITCH", 5, dashed},
                                    {"roller", "ROLLER", 3},
                                    {"axes", "AXES", 1, center}};
    const std::initializer_list<DxfStyle> of_disks = {{"circle", "BASE_CIRCLE", 8, dashed},
                                                      {"prime", "PRIME_CIRCLE", 8, dashed},
                                                      {"face", "FACE", 3},
                                                      {"groove", "OUTER_FLANK"},
                                                      {"rim", "RIM", 8},
                                                      {"second", "SECOND_CAM"},
                                                      {"second-pitch", "SECOND_PITCH", 5, dashed},
                                                      {"second-roller", "SECOND_ROLLER", 3},
                                                      {"open", "OPEN", 1, dashed}};
    if (shape.direct) styles.insert(styles.end(), of_disks);
    return styles;
}

/// The cam's direction of travel reverses at its cusps, the pitch curve's does not.
std::vector<double> knots_with_cusps(const ProfileShape& shape) {
    std::vector<double> knots = shape.knots;
    const std::vector<double> cusps = cusp_angles(shape);
    knots.insert(knots.end(), cusps.begin(), cusps.end());
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    return knots;
}

/// Where the motion begins, in the cam frame.
void add_follower(Drawing& drawing, const ProfileShape& shape, double reach) {
    const std::vector<MechanismShape> parts = placed_parts(shape, shape.start, shape.start);
    const Vector2d center = parts.front().points.front();
    const MechanismPoint point = shape.at(shape.start);
    const Vector2d pitch = in_plane(point.pitch), contact = in_plane(point.contact);
    Vector2d from = pitch, to = pitch;  // along a face
    std::set<PartKind> seen;
    for (const MechanismShape& part : parts) {
        const Vector2d first = part.points.front() - center, last = part.points.back() - center;
        const bool leads = seen.insert(part.kind).second;  // not the second disk's
        if (part.kind == PartKind::circle)
            drawing.circle(leads ? "roller" : "second-roller", first, part.radius);
        if (part.kind == PartKind::face) from = first, to = last;
        if (part.kind != PartKind::link || !leads || !shape.direct) continue;
        if (!shape.formulas().swings()) {
            drawing.line("axes", pitch, pitch + 0.5 * reach * (last - first).normalized());
            continue;
        }
        if (!shape.is_plate()) drawing.line("axes", {0.0, 0.0}, last);
        drawing.line("axes", last, first);
        drawing.circle("axes", last, pivot_size * shape.base_radius());
    }
    if (!shape.has_face()) return;
    if (!shape.has_pushed_face()) return drawing.line("face", from, contact + 0.5 * (contact - from));
    const Vector2d half = shape.face_half_width.value_or(0.5 * reach) * (to - from);
    drawing.line("face", from + half, from - half);
}

/// Arcs within the tolerance and the printed digits, with a twentieth more as room for the proof.
std::string drawing_claims(const Solution& solution, double tolerance, bool has_pitch) {
    constexpr double room = 1.05, printed = 1e-8;  // m
    const double most = millimetres_shown.of(room * tolerance + printed);
    Json departure = {{"profile_mm", most}};
    if (has_pitch) departure["pitch_mm"] = most;
    return export_check_json(
        solution,
        {{"camopt", version()}, {"kind", "dxf"}, {"file", drawn_profile}, {"departure", departure}});
}

}  // namespace

std::vector<FolderFile> dxf_files(const View& view, double tolerance) {
    const std::optional<ProfileShape> shape = plane_shape(view);
    if (!shape) return {};
    ProfileDxf drawn = profile_dxf(*shape, tolerance);
    return {{drawn_profile, std::move(drawn.text)},
            {drawn_profile_check, drawing_claims(view.solution, tolerance, drawn.pitch_arcs > 0)}};
}

ProfileDxf cam_dxf(const View& view, double tolerance) {
    if (const std::optional<ProfileShape> shape = plane_shape(view)) return profile_dxf(*shape, tolerance);
    throw InputError("a drawing needs the cam of a plane mechanism, and this solution has none");
}

ArcChain outline_chain(const ProfileShape& shape, bool of_cam, double tolerance) {
    const PlaneCurve curve = [&](double theta) {
        const MechanismPoint point = shape.at(theta);
        return CurvePoint{in_plane(of_cam ? point.contact : point.pitch), in_plane(point.normal)};
    };
    ArcChainOptions options;
    options.tolerance = tolerance;
    return arc_chain(curve, of_cam ? knots_with_cusps(shape) : shape.knots, shape.closed, options);
}

ProfileDxf profile_dxf(const ProfileShape& shape, double tolerance) {
    ProfileDxf result;
    double greatest = rim_radius(shape).value_or(0.0);
    Drawing drawing = cam_outlines(shape, [&](const ProfileShape& side, bool of_cam) {
        ArcChain chain = outline_chain(side, of_cam, tolerance);
        double& deviation = of_cam ? result.deviation : result.pitch_deviation;
        deviation = std::max(deviation, chain.deviation);
        (of_cam ? result.arcs : result.pitch_arcs) += chain.arcs;
        if (of_cam) greatest = std::max(greatest, largest_radius(chain));
        return std::move(chain.vertices);
    });
    const double reach = axis_overhang * greatest;
    if (!shape.is_plate()) {
        drawing.line("axes", {-reach, 0.0}, {reach, 0.0});
        drawing.line("axes", {0.0, -reach}, {0.0, reach});
    }
    add_follower(drawing, shape, reach);
    if (!shape.closed && !shape.open_because.empty())  // what is missing, where the line to it ends
        drawing.elements.emplace_back(DrawnText{"open", 1.1 * in_plane(shape.at(shape.end()).contact),
                                                opening_text * shape.base_radius(),
                                                "OPEN: " + shape.open_because});
    result.text = dxf_of(drawing, styles_of(shape));
    return result;
}

}  // namespace camopt
