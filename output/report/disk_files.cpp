// SPDX-License-Identifier: MIT
#include "output/chart/limit_spans.hpp"
#include "output/chart/profile_diagrams_svg.hpp"
#include "output/csv/profile_csv.hpp"
#include "output/drawing/profile_svg.hpp"
#include "output/report/cam_texts.hpp"
#include "output/words/cam_words.hpp"
#include "profiles/disk/disk_mechanism.hpp"
#include "scene/limit_table.hpp"
#include "studies/check/check_cam.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace camopt {

namespace {

std::optional<double> value_of(const std::optional<WrittenLimit>& limit) {
    if (!limit) return {};
    return limit->value;
}

std::string csv_of(const DiskCam& cam, const Motion& motion, const MotionScale& scale,
                   const CamFileOptions& options) {
    MechanismProfile profile;
    for (const ProfilePoint& point :
         sampled_profile(cam, motion, scale, {options.points, options.chord_tolerance})) {
        const double x = std::clamp(point.theta / scale.unit_angle, motion.begin(), motion.end());
        profile.points.push_back(mechanism_point(point));
        profile.outputs.push_back(scale.lift * motion.at(x).derivative[0]);
    }
    return profile_csv(profile, {is_oscillating(cam.follower), has_flat_face(cam.follower)});
}

/// Where the report says that the extremes are: one source, so that both name the same angle where a
/// maximum is flat or is reached twice.
ProfileDiagramMarks marks_of(const ProfileShape& shape, const CamSummary& summary, double unit_angle) {
    ProfileDiagramMarks marks;
    const auto add_pressure = [&](const std::optional<CamExtreme>& extreme) {
        if (!extreme || !(extreme->value > 0.0)) return;
        const double theta = unit_angle * extreme->at;
        if (std::ranges::find(marks.pressure, theta, &ProfileMark::theta) != marks.pressure.end()) return;
        marks.pressure.push_back({theta, std::copysign(extreme->value, shape.at(theta).pressure_angle)});
    };
    add_pressure(summary.pressure_angle);
    add_pressure(summary.rise_pressure_angle);
    add_pressure(summary.return_pressure_angle);
    if (const std::optional<CamExtreme> convex = convex_radius(summary))
        marks.curvature.push_back({unit_angle * convex->at, 1.0 / convex->value});
    if (summary.concave_radius)
        marks.curvature.push_back(
            {unit_angle * summary.concave_radius->at, -1.0 / summary.concave_radius->value});
    return marks;
}

}  // namespace

std::vector<std::string> disk_texts(const Solution& solution, const CamFileOptions& options) {
    const MotionChain motion = cam_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const ProfileShape shape = disk_shape(solution, motion).value();
    const std::string title = solution.scene.title.empty() ? "Cam" : solution.scene.title;
    const ProfileDiagramLimits limits{
        pressure_spans(solution.scene, motion),
        value_of(limit_on(solution.scene.limits, LimitedFigure::convex_radius)),
        value_of(limit_on(solution.scene.limits, LimitedFigure::concave_radius))};
    const ProfileDiagramMarks marks = marks_of(shape, solution.cam->summary, scale.unit_angle);
    return {csv_of(shape.cam, motion, scale, options), profile_svg(shape, title),
            profile_diagrams_svg(shape, limits, title, marks)};
}

}  // namespace camopt
