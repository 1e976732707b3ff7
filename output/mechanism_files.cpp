// SPDX-License-Identifier: MIT
#include "output/mechanism_files.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/csv_line.hpp"
#include "output/mechanism_svg.hpp"
#include "output/paper_figure_svg.hpp"
#include "studies/check_cam.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace camopt {

namespace {

using units::degree, units::millimetre;

constexpr double points_a_turn = 3600.0;

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

/// A level line over the whole motion.
PaperSeries level(const std::string& title, const MechanismProfile& profile, double value) {
    return {
        title, {profile.points.front().theta / degree, profile.points.back().theta / degree}, {value, value}};
}

template <class Figure>
PaperSeries series_of(const std::string& title, const MechanismProfile& profile, const Figure& figure) {
    PaperSeries series{title, {}, {}};
    for (const MechanismPoint& point : profile.points) {
        series.x.push_back(point.theta / degree);
        series.y.push_back(figure(point));
    }
    return series;
}

std::string pressure_svg(const Solution& solution, const MechanismProfile& profile) {
    PaperFigure figure{"pressure_angle", "Pressure angle", "cam angle (deg)", "pressure angle (deg)", {}};
    figure.series.push_back(series_of("pressure angle", profile, [](const MechanismPoint& point) {
        return point.pressure_angle / degree;
    }));
    if (const auto& limit = solution.scene.limits.pressure_angle) {
        PaperSeries both = level("limit", profile, limit->value / degree);
        const PaperSeries lower = level("", profile, -limit->value / degree);
        both.x.push_back(std::numeric_limits<double>::quiet_NaN());  // lifts the pen
        both.y.push_back(std::numeric_limits<double>::quiet_NaN());
        both.x.insert(both.x.end(), lower.x.begin(), lower.x.end());
        both.y.insert(both.y.end(), lower.y.begin(), lower.y.end());
        figure.series.push_back(std::move(both));
    }
    return paper_figure_svg(figure);
}

std::string curvature_svg(const Solution& solution, const MechanismProfile& profile) {
    PaperFigure figure{
        "curvature", "Curvature of the cam, > 0 convex", "cam angle (deg)", "curvature (1/mm)", {}};
    figure.series.push_back(
        series_of("cam", profile, [](const MechanismPoint& point) { return millimetre / point.cam_radius; }));
    if (const auto& limit = solution.scene.limits.cam_radius_min; limit && limit->value > 0.0)
        figure.series.push_back(level("least convex radius", profile, millimetre / limit->value));
    return paper_figure_svg(figure);
}

}  // namespace

MechanismTexts mechanism_texts(const Solution& solution, std::optional<int> points) {
    if (!solution.mechanism || !solution.mechanism->mechanism.formulas->planar())
        throw InputError("a plane profile needs a plane mechanism, and this solution has none");
    const MotionChain motion = cam_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const double turns = (motion.end() - motion.begin()) * scale.unit_angle / (2.0 * std::numbers::pi);
    const int count = points.value_or(1 + static_cast<int>(std::ceil(points_a_turn * turns)));
    const DrivenMechanism& mechanism = solution.mechanism->mechanism;
    const MechanismProfile profile = mechanism_profile(mechanism, motion, scale, count);
    const std::string title = solution.scene.title.empty() ? "Cam and linkage" : solution.scene.title;
    return {csv_of(profile, solution.scene.motion.lift_is_angle),
            mechanism_svg({mechanism, motion, scale}, title), pressure_svg(solution, profile),
            curvature_svg(solution, profile)};
}

}  // namespace camopt
