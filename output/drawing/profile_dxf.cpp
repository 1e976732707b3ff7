// SPDX-License-Identifier: MIT
#include "output/drawing/profile_dxf.hpp"

#include "output/drawing/arc_chain.hpp"
#include "output/drawing/dxf_drawing.hpp"

#include <algorithm>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double pivot_size = 0.05, opening_text = 0.05;  // of the base radius

std::vector<DxfLayer> layers() {
    return {{"CAM", 7, DxfLine::continuous},     {"PITCH", 5, DxfLine::dashed},
            {"BASE_CIRCLE", 8, DxfLine::dashed}, {"PRIME_CIRCLE", 8, DxfLine::dashed},
            {"ROLLER", 3, DxfLine::continuous},  {"FACE", 3, DxfLine::continuous},
            {"AXES", 1, DxfLine::center}};
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

ArcChain drawn_chain(DxfDrawing& drawing, const char* layer, const ProfileShape& shape, double tolerance) {
    ArcChain chain = outline_chain(shape, std::string_view(layer) == "CAM", tolerance);
    drawing.polyline(layer, chain.vertices, chain.closed);
    return chain;
}

void draw_follower(DxfDrawing& drawing, const ProfileShape& shape, double reach) {
    const DiskCam& cam = shape.cam;
    const ProfilePoint point = shape.at(shape.start);
    const FollowerPose pose = follower_pose(cam, point);
    if (has_roller(cam.follower)) drawing.circle("ROLLER", point.pitch, cam[DimensionIndex::roller_radius]);
    if (is_oscillating(cam.follower)) {
        const bool flat = has_flat_face(cam.follower);
        drawing.line("AXES", {0.0, 0.0}, pose.pivot);
        drawing.line("AXES", pose.pivot, flat ? pose.foot : point.pitch);
        drawing.circle("AXES", pose.pivot, pivot_size * cam[DimensionIndex::base_radius]);
        if (flat) drawing.line("FACE", pose.foot, point.contact + 0.5 * (point.contact - pose.foot));
        return;
    }
    drawing.line("AXES", point.pitch, point.pitch + 0.5 * reach * pose.lift);
    if (!has_flat_face(cam.follower)) return;
    const Vector2d along(-pose.lift.y(), pose.lift.x());
    const Vector2d middle = point.contact - along * along.dot(point.contact);
    const double half = shape.face_half_width.value_or(0.5 * reach);
    drawing.line("FACE", middle - half * along, middle + half * along);
}

/// Where the scene says nothing of the cam, a line between its ends, and what is missing.
void draw_opening(DxfDrawing& drawing, const ProfileShape& shape, double size) {
    if (shape.closed || shape.open_because.empty()) return;
    const Vector2d from = shape.at(shape.begin()).contact, to = shape.at(shape.end()).contact;
    drawing.line("OPEN", from, to);
    drawing.text("OPEN",
                 {1.1 * to, opening_text * size, "OPEN: " + shape.open_because, DxfText::Anchor::start, 0.0});
}

}  // namespace

ArcChain outline_chain(const ProfileShape& shape, bool of_cam, double tolerance) {
    const PlaneCurve curve = [&](double theta) {
        const ProfilePoint point = shape.at(theta);
        return CurvePoint{of_cam ? point.contact : point.pitch, point.normal};
    };
    ArcChainOptions options;
    options.tolerance = tolerance;
    return arc_chain(curve, of_cam ? knots_with_cusps(shape) : shape.knots, shape.closed, options);
}

ProfileDxf profile_dxf(const ProfileShape& shape, double tolerance) {
    std::vector<DxfLayer> used = layers();
    if (!shape.closed && !shape.open_because.empty()) used.push_back({"OPEN", 1, DxfLine::dashed});
    DxfDrawing drawing(std::move(used));
    ProfileDxf result;
    const ArcChain outline = drawn_chain(drawing, "CAM", shape, tolerance);
    result.arcs = outline.arcs;
    result.deviation = outline.deviation;
    const double base = shape.cam[DimensionIndex::base_radius];
    drawing.circle("BASE_CIRCLE", {0.0, 0.0}, base);
    if (has_roller(shape.cam.follower)) {
        const ArcChain pitch = drawn_chain(drawing, "PITCH", shape, tolerance);
        result.pitch_arcs = pitch.arcs;
        result.pitch_deviation = pitch.deviation;
        drawing.circle("PRIME_CIRCLE", {0.0, 0.0}, base + shape.cam[DimensionIndex::roller_radius]);
    }
    const double reach = axis_overhang * largest_radius(outline);
    drawing.line("AXES", {-reach, 0.0}, {reach, 0.0});
    drawing.line("AXES", {0.0, -reach}, {0.0, reach});
    draw_follower(drawing, shape, reach);
    draw_opening(drawing, shape, base);
    result.text = drawing.finish();
    return result;
}

}  // namespace camopt
