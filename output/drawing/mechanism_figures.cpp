// SPDX-License-Identifier: MIT
#include "output/drawing/mechanism_figures.hpp"

#include "core/units.hpp"
#include "output/chart/paper_figure_svg.hpp"
#include "output/words/shown_units.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace camopt {

namespace {

using units::degree;

constexpr double points_a_turn = 3600.0;

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

}  // namespace

std::string pressure_angle_svg(const Solution& solution, const MechanismProfile& profile) {
    PaperFigure figure{"pressure_angle", "Pressure angle", "cam angle (deg)", "pressure angle (deg)", {}};
    figure.series.push_back(series_of("pressure angle", profile, [](const MechanismPoint& point) {
        return point.pressure_angle / degree;
    }));
    if (const auto& limit = limit_on(solution.scene.limits, LimitedFigure::pressure_angle)) {
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
    const ShownUnit curvature = shown_units(solution.scene).curvature;
    PaperFigure figure{"curvature",
                       "Curvature of the cam, > 0 convex",
                       "cam angle (deg)",
                       fmt::format("curvature ({})", curvature.name),
                       {}};
    figure.series.push_back(series_of(
        "cam", profile, [&](const MechanismPoint& point) { return curvature.factor / point.cam_radius; }));
    if (const auto& limit = limit_on(solution.scene.limits, LimitedFigure::convex_radius);
        limit && limit->value > 0.0)
        figure.series.push_back(level("least convex radius", profile, curvature.factor / limit->value));
    return paper_figure_svg(figure);
}

int default_profile_points(const Motion& motion, const MotionScale& scale) {
    const double turns = (motion.end() - motion.begin()) * scale.unit_angle / units::turn;
    return 1 + static_cast<int>(std::ceil(points_a_turn * turns));
}

}  // namespace camopt
