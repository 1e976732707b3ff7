// SPDX-License-Identifier: MIT
#include "output/chart/limit_spans.hpp"
#include "output/chart/profile_diagrams_svg.hpp"
#include "output/csv/profile_csv.hpp"
#include "output/drawing/profile_svg.hpp"
#include "output/report/cam_texts.hpp"
#include "output/words/cam_words.hpp"
#include "profiles/disk/disk_mechanism.hpp"
#include "profiles/disk/disk_sides.hpp"
#include "scene/limit_table.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/delivered/cam/follower_loads.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace camopt {

namespace {

std::optional<double> value_of(const std::optional<WrittenLimit>& limit) {
    if (!limit) return {};
    return limit->value;
}

/// Of each point; none where the scene has no forces. Of a cam that drives both ways those of one side: 0
/// along the normal where the other one carries.
std::vector<FollowerLoads> loads_of(const Solution& solution, const Motion& motion,
                                    const MechanismProfile& profile, int side) {
    const LoadsAt loads = delivered_loads(solution);
    if (!loads) return {};
    const double unit_angle = motion_scale(solution.scene).unit_angle;
    std::vector<FollowerLoads> all;
    for (const MechanismPoint& point : profile.points) {
        const double x = std::clamp(point.theta / unit_angle, motion.begin(), motion.end());
        all.push_back(loads(motion.at(x, x < motion.end() ? Side::right : Side::left), point));
        if (all.back().side == side || solution.cam->summary.no_contact) continue;
        all.back().normal_force = 0.0;
        if (all.back().hertz_pressure) all.back().hertz_pressure = 0.0;
    }
    return all;
}

std::string csv_of(const Solution& solution, const DiskCam& cam, const Motion& motion,
                   const CamFileOptions& options, int side) {
    const MotionScale scale = motion_scale(solution.scene);
    MechanismProfile profile;
    for (const ProfilePoint& point :
         sampled_profile(cam, motion, scale, {options.points, options.chord_tolerance}, side)) {
        const double x = std::clamp(point.theta / scale.unit_angle, motion.begin(), motion.end());
        profile.points.push_back(mechanism_point(point));
        profile.outputs.push_back(scale.lift * motion.at(x).derivative[0]);
    }
    ProfileColumns columns{
        .swings = is_oscillating(cam.follower), .face = has_flat_face(cam.follower), .loads = {}};
    columns.loads = loads_of(solution, motion, profile, side);
    columns.pressure = solution.cam->summary.forces && solution.cam->summary.forces->hertz_pressure;
    return profile_csv(profile, columns);
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
    if (!summary.sides.empty()) return marks;  // its panels are the sides', which find their own
    if (const std::optional<CamExtreme> convex = convex_radius(summary))
        marks.curvature.push_back({unit_angle * convex->at, 1.0 / convex->value});
    if (summary.concave_radius)
        marks.curvature.push_back(
            {unit_angle * summary.concave_radius->at, -1.0 / summary.concave_radius->value});
    return marks;
}

}  // namespace

std::vector<std::string> disk_texts(const Solution& solution, const CamFileOptions& options) {
    const MotionChain motion = cam_motion(solution), drawn = drawn_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    // The diagrams show the motion alone: along a dwell arc nothing changes.
    const ProfileShape shape = disk_shape(solution, motion).value(),
                       whole = disk_shape(solution, drawn).value();
    const std::string title = solution.scene.title.empty() ? "Cam" : solution.scene.title;
    const ProfileDiagramLimits limits{
        pressure_spans(solution.scene, motion),
        value_of(limit_on(solution.scene.limits, LimitedFigure::convex_radius)),
        value_of(limit_on(solution.scene.limits, LimitedFigure::concave_radius))};
    const ProfileDiagramMarks marks = marks_of(shape, solution.cam->summary, scale.unit_angle);
    std::vector<std::string> texts = {csv_of(solution, shape.cam, drawn, options, 0),
                                      profile_svg(whole, title),
                                      profile_diagrams_svg(shape, limits, title, marks)};
    if (side_count(shape.cam) > 1) texts.push_back(csv_of(solution, shape.cam, drawn, options, 1));
    return texts;
}

}  // namespace camopt
