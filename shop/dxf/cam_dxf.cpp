// SPDX-License-Identifier: MIT
#include "shop/dxf/cam_dxf.hpp"

#include "core/version.hpp"
#include "report/cam/cam_files.hpp"
#include "report/json/json_text.hpp"
#include "shop/dxf/dxf_drawing.hpp"

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double closing = 1e-9;  // of the largest radius: ends this close are one point
constexpr int reversal_bisections = 60;
constexpr int sign_samples = 3600;  // in which the reversals of an undercut outline are searched for

/// The mechanism's cam at any x of the motion.
class Outline {
 public:
    explicit Outline(const CamPoints& points) : points_(points), motion_(points.motion()) {}

    [[nodiscard]] const MechanismPoint& at(double x, int station) const { return points_.at(x, station); }
    /// Where the motion changes its formula and where the outline's direction of travel reverses.
    [[nodiscard]] std::vector<double> knots(int station) const {
        std::vector<double> all = motion_.breakpoints();
        const double length = motion_.end() - motion_.begin();
        double before = at(motion_.begin(), station).regularity;
        for (int i = 1; i <= sign_samples; ++i) {
            const double right = motion_.begin() + length * i / sign_samples;
            const double now = at(right, station).regularity;
            if (before * now < 0.0) all.push_back(reversal(right - length / sign_samples, right, station));
            before = now;
        }
        std::ranges::sort(all);
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }
    [[nodiscard]] std::vector<double> breakpoints() const { return motion_.breakpoints(); }
    [[nodiscard]] bool closed(double size) const {
        const Vector2d gap = (at(motion_.end(), 0).contact - at(motion_.begin(), 0).contact).head<2>();
        return is_whole_turn((motion_.end() - motion_.begin()) * points_.scale().unit_angle) &&
               gap.norm() < closing * size;
    }

 private:
    [[nodiscard]] double reversal(double left, double right, int station) const {
        const bool falling = at(left, station).regularity > 0.0;
        const auto like_left = [&](double x) { return (at(x, station).regularity > 0.0) == falling; };
        return bisected(like_left, {left, right}, reversal_bisections).without;
    }

    const CamPoints& points_;
    const Motion& motion_;
};

ArcChain chain_of(const Outline& outline, int station, bool of_cam, bool closed, double tolerance,
                  double unit_angle) {
    const PlaneCurve curve = [&](double x) {
        const MechanismPoint& point = outline.at(x, station);
        return CurvePoint{(of_cam ? point.contact : point.pitch).head<2>(), point.normal.head<2>()};
    };
    ArcChainOptions options;
    options.tolerance = tolerance;
    options.longest_step /= unit_angle;
    return arc_chain(curve, of_cam ? outline.knots(station) : outline.breakpoints(), closed, options);
}

ProfileDxf outline_dxf(const CamPoints& points, double tolerance) {
    const Outline outline(points);
    const CamMechanism& formulas = *points.cam().formulas;
    const Motion& motion = points.motion();
    const bool guide = formulas.has_guide();
    const char* const cam = guide ? "WALLS" : "CAM";
    DxfDrawing drawing({{cam, 7, DxfLine::continuous},
                        {"PITCH", 5, DxfLine::dashed},
                        {"ROLLER", 3, DxfLine::continuous},
                        {"AXES", 1, DxfLine::center}});
    const double size = outline.at(motion.end(), 0).pitch.norm();
    const bool closed = !guide && outline.closed(size);
    ProfileDxf result;
    double reach = 0.0;
    for (int station = 0; station < formulas.stations(); ++station) {
        const ArcChain chain = chain_of(outline, station, true, closed, tolerance, points.scale().unit_angle);
        drawing.polyline(cam, chain.vertices, chain.closed);
        result.arcs += chain.arcs;
        result.deviation = std::max(result.deviation, chain.deviation);
        reach = std::max(reach, axis_overhang * largest_radius(chain));
    }
    const ArcChain pitch = chain_of(outline, 0, false, closed, tolerance, points.scale().unit_angle);
    drawing.polyline("PITCH", pitch.vertices, pitch.closed);
    result.pitch_arcs = pitch.arcs;
    result.pitch_deviation = pitch.deviation;
    const MechanismPoint first = outline.at(std::clamp(0.0, motion.begin(), motion.end()), 0);
    drawing.circle("ROLLER", first.pitch.head<2>(), (first.contact - first.pitch).norm());
    drawing.line("AXES", {-reach, 0.0}, {reach, 0.0});
    drawing.line("AXES", {0.0, -reach}, {0.0, reach});
    result.text = drawing.finish();
    return result;
}

constexpr double pivot_size = 0.05, opening_text = 0.05;  // of the base radius

/// Where the outline of a side lies: an open cam, or the first disk, is the CAM.
const char* outline_layer(const ProfileShape& shape, int side) {
    if (shape.is_grooved()) return side == 0 ? "INNER_FLANK" : "OUTER_FLANK";
    return side == 0 ? "CAM" : "SECOND_CAM";
}

std::vector<DxfLayer> layers(const ProfileShape& shape) {
    std::vector<DxfLayer> all = {{outline_layer(shape, 0), 7, DxfLine::continuous},
                                 {"PITCH", 5, DxfLine::dashed},
                                 {"BASE_CIRCLE", 8, DxfLine::dashed},
                                 {"PRIME_CIRCLE", 8, DxfLine::dashed},
                                 {"ROLLER", 3, DxfLine::continuous},
                                 {"FACE", 3, DxfLine::continuous},
                                 {"AXES", 1, DxfLine::center}};
    if (!shape.other) return all;
    all.push_back({outline_layer(shape, 1), 7, DxfLine::continuous});
    if (shape.is_grooved()) all.push_back({"RIM", 8, DxfLine::continuous});
    if (shape.has_two_disks()) {
        all.push_back({"SECOND_PITCH", 5, DxfLine::dashed});
        all.push_back({"SECOND_ROLLER", 3, DxfLine::continuous});
    }
    return all;
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

ArcChain drawn_chain(DxfDrawing& drawing, const char* layer, const ProfileShape& shape, double tolerance,
                     bool of_cam) {
    ArcChain chain = outline_chain(shape, of_cam, tolerance);
    drawing.polyline(layer, chain.vertices, chain.closed);
    return chain;
}

void draw_follower(DxfDrawing& drawing, const ProfileShape& shape, double reach) {
    const MechanismPoint point = shape.at(shape.start);
    const Vector2d pitch = in_plane(point.pitch), contact = in_plane(point.contact);
    const FollowerPose pose = follower_pose(shape.cam, point);
    const bool flat = shape.has_face();
    if (shape.has_roller()) drawing.circle("ROLLER", pitch, shape.roller_radius());
    if (shape.formulas().swings()) {
        drawing.line("AXES", {0.0, 0.0}, pose.pivot);
        drawing.line("AXES", pose.pivot, flat ? pose.foot : pitch);
        drawing.circle("AXES", pose.pivot, pivot_size * shape.base_radius());
        if (flat) drawing.line("FACE", pose.foot, contact + 0.5 * (contact - pose.foot));
        return;
    }
    drawing.line("AXES", pitch, pitch + 0.5 * reach * pose.lift);
    if (!flat) return;
    const Vector2d along(-pose.lift.y(), pose.lift.x());
    const Vector2d middle = contact - along * along.dot(contact);
    const double half = shape.face_half_width.value_or(0.5 * reach);
    drawing.line("FACE", middle - half * along, middle + half * along);
}

/// Where the scene says nothing of the cam, a line between its ends, and what is missing.
void draw_opening(DxfDrawing& drawing, const ProfileShape& shape, double size) {
    if (shape.closed || shape.open_because.empty()) return;
    const Vector2d from = in_plane(shape.at(shape.begin()).contact),
                   to = in_plane(shape.at(shape.end()).contact);
    drawing.line("OPEN", from, to);
    drawing.text("OPEN",
                 {1.1 * to, opening_text * size, "OPEN: " + shape.open_because, DxfText::Anchor::start, 0.0});
}

/// Its greatest radius, that of a groove's rim included.
double draw_other_side(DxfDrawing& drawing, const ProfileShape& shape, double tolerance, ProfileDxf& result) {
    const ProfileShape other = other_side(shape);
    const ArcChain outline = drawn_chain(drawing, outline_layer(shape, 1), other, tolerance, true);
    result.arcs += outline.arcs;
    result.deviation = std::max(result.deviation, outline.deviation);
    if (const std::optional<double> rim = rim_radius(shape)) {
        drawing.circle("RIM", {0.0, 0.0}, *rim);
        return *rim;
    }
    const ArcChain pitch = drawn_chain(drawing, "SECOND_PITCH", other, tolerance, false);
    result.pitch_arcs += pitch.arcs;
    result.pitch_deviation = std::max(result.pitch_deviation, pitch.deviation);
    drawing.circle("SECOND_ROLLER", in_plane(other.at(shape.start).pitch), shape.roller_radius(1));
    return largest_radius(outline);
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
    if (!view.delivered.cam || !view.delivered.cam->cam().formulas->is_plane_curve()) return {};
    ProfileDxf drawn = cam_dxf(view, tolerance);
    return {{drawn_profile, std::move(drawn.text)},
            {drawn_profile_check, drawing_claims(view.solution, tolerance, drawn.pitch_arcs > 0)}};
}

ProfileDxf cam_dxf(const View& view, double tolerance) {
    if (!view.delivered.cam || !view.delivered.cam->cam().formulas->is_plane_curve())
        throw InputError("a drawing needs the cam of a plane mechanism, and this solution has none");
    if (const std::optional<ProfileShape> shape = delivered_shape(view))
        return profile_dxf(*shape, tolerance);
    return outline_dxf(*view.delivered.cam, tolerance);
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
    std::vector<DxfLayer> used = layers(shape);
    if (!shape.closed && !shape.open_because.empty()) used.push_back({"OPEN", 1, DxfLine::dashed});
    DxfDrawing drawing(std::move(used));
    ProfileDxf result;
    const ArcChain outline = drawn_chain(drawing, outline_layer(shape, 0), shape, tolerance, true);
    result.arcs = outline.arcs;
    result.deviation = outline.deviation;
    const double base = shape.base_radius();
    drawing.circle("BASE_CIRCLE", {0.0, 0.0}, base);
    if (shape.has_roller()) {
        const ArcChain pitch = drawn_chain(drawing, "PITCH", shape, tolerance, false);
        result.pitch_arcs = pitch.arcs;
        result.pitch_deviation = pitch.deviation;
        drawing.circle("PRIME_CIRCLE", {0.0, 0.0}, shape.prime_radius());
    }
    double greatest = largest_radius(outline);
    if (shape.other) greatest = std::max(greatest, draw_other_side(drawing, shape, tolerance, result));
    const double reach = axis_overhang * greatest;
    drawing.line("AXES", {-reach, 0.0}, {reach, 0.0});
    drawing.line("AXES", {0.0, -reach}, {0.0, reach});
    draw_follower(drawing, shape, reach);
    draw_opening(drawing, shape, base);
    result.text = drawing.finish();
    return result;
}

}  // namespace camopt
