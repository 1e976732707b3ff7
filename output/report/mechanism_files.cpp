// SPDX-License-Identifier: MIT
#include "output/report/mechanism_files.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/csv/csv_line.hpp"
#include "output/drawing/mechanism_figures.hpp"
#include "output/drawing/mechanism_svg.hpp"
#include "studies/check/check_cam.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using units::degree, units::millimetre;

std::string csv_of(const MechanismProfile& profile, bool swings) {
    std::string text = fmt::format(
        "theta_deg,{},pitch_x_mm,pitch_y_mm,cam_x_mm,cam_y_mm,normal_x,normal_y,pressure_angle_deg,"
        "pitch_radius_mm,cam_radius_mm,regularity\n",
        swings ? "s_deg" : "s_mm");
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        const MechanismPoint& point = profile.points[i];
        CsvLine line;
        line.number(point.theta / degree).number(profile.outputs[i] / (swings ? degree : millimetre));
        for (const Eigen::Vector3d& place : {point.pitch, point.contact})
            line.number(place.x() / millimetre).number(place.y() / millimetre);
        line.number(point.normal.x()).number(point.normal.y()).number(point.pressure_angle / degree);
        line.number(1.0 / (point.pitch_curvature * millimetre)).number(point.cam_radius / millimetre);
        line.number(point.regularity);
        text += line.finish();
    }
    return text;
}

}  // namespace

MechanismTexts mechanism_texts(const Solution& solution, std::optional<int> points) {
    if (!solution.mechanism || !solution.mechanism->mechanism.formulas->planar())
        throw InputError("a plane profile needs a plane mechanism, and this solution has none");
    const MotionChain motion = cam_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const int count = points.value_or(default_profile_points(motion, scale));
    const DrivenMechanism& mechanism = solution.mechanism->mechanism;
    const MechanismProfile profile = mechanism_profile(mechanism, motion, scale, count);
    const std::string title = solution.scene.title.empty() ? "Cam and linkage" : solution.scene.title;
    return {csv_of(profile, solution.scene.motion.lift_is_angle),
            mechanism_svg({mechanism, motion, scale}, title), pressure_angle_svg(solution, profile),
            curvature_svg(solution, profile)};
}

}  // namespace camopt
