// SPDX-License-Identifier: MIT
#include "output/drawing/dxf/cam_dxf.hpp"

#include "core/errors.hpp"
#include "core/numbers/scalar_search.hpp"
#include "core/whole_turn.hpp"
#include "output/drawing/arc_chain.hpp"
#include "output/drawing/dxf/dxf_drawing.hpp"
#include "output/drawing/profile_shape.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/delivered/driven_mechanism.hpp"

#include <algorithm>
#include <optional>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double closing = 1e-9;  // of the largest radius: ends this close are one point
constexpr int reversal_bisections = 60;
constexpr int sign_samples = 3600;  // in which the reversals of an undercut outline are looked for

/// The mechanism's cam at any x of the motion.
class Outline {
 public:
    Outline(const DrivenMechanism& mechanism, const Motion& motion, const MotionScale& scale)
        : mechanism_(mechanism), motion_(motion), scale_(scale) {}

    [[nodiscard]] MechanismPoint at(double x, int station) const {
        const double place = std::clamp(x, motion_.begin(), motion_.end());
        return mechanism_point(
            mechanism_, motion_.at(place, place < motion_.end() ? Side::right : Side::left), scale_, station);
    }
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
        return is_whole_turn((motion_.end() - motion_.begin()) * scale_.unit_angle) &&
               gap.norm() < closing * size;
    }

 private:
    [[nodiscard]] double reversal(double left, double right, int station) const {
        const bool falling = at(left, station).regularity > 0.0;
        const auto like_left = [&](double x) { return (at(x, station).regularity > 0.0) == falling; };
        return bisected(like_left, {left, right}, reversal_bisections).without;
    }

    const DrivenMechanism& mechanism_;
    const Motion& motion_;
    MotionScale scale_;
};

ArcChain chain_of(const Outline& outline, int station, bool of_cam, bool closed, double tolerance,
                  double unit_angle) {
    const PlaneCurve curve = [&](double x) {
        const MechanismPoint point = outline.at(x, station);
        return CurvePoint{(of_cam ? point.contact : point.pitch).head<2>(), point.normal.head<2>()};
    };
    ArcChainOptions options;
    options.tolerance = tolerance;
    options.longest_step /= unit_angle;
    return arc_chain(curve, of_cam ? outline.knots(station) : outline.breakpoints(), closed, options);
}

ProfileDxf outline_dxf(const DrivenMechanism& mechanism, const Motion& motion, const MotionScale& scale,
                       double tolerance) {
    const Outline outline(mechanism, motion, scale);
    const bool guide = mechanism.formulas->has_guide();
    const char* const cam = guide ? "WALLS" : "CAM";
    DxfDrawing drawing({{cam, 7, DxfLine::continuous},
                        {"PITCH", 5, DxfLine::dashed},
                        {"ROLLER", 3, DxfLine::continuous},
                        {"AXES", 1, DxfLine::center}});
    const double size = outline.at(motion.end(), 0).pitch.norm();
    const bool closed = !guide && outline.closed(size);
    ProfileDxf result;
    double reach = 0.0;
    for (int station = 0; station < mechanism.formulas->stations(); ++station) {
        const ArcChain chain = chain_of(outline, station, true, closed, tolerance, scale.unit_angle);
        drawing.polyline(cam, chain.vertices, chain.closed);
        result.arcs += chain.arcs;
        result.deviation = std::max(result.deviation, chain.deviation);
        reach = std::max(reach, axis_overhang * largest_radius(chain));
    }
    const ArcChain pitch = chain_of(outline, 0, false, closed, tolerance, scale.unit_angle);
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

}  // namespace

ProfileDxf cam_dxf(const Solution& solution, double tolerance) {
    if (!solution.cam || !solution.cam->cam.formulas->is_plane_curve())
        throw InputError("a drawing needs the cam of a plane mechanism, and this solution has none");
    const MotionChain motion = drawn_motion(solution);
    if (const std::optional<ProfileShape> shape = disk_shape(solution, motion))
        return profile_dxf(*shape, tolerance);
    return outline_dxf(solution.cam->cam, motion, motion_scale(solution.scene), tolerance);
}

}  // namespace camopt
