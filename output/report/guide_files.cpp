// SPDX-License-Identifier: MIT
#include "core/units.hpp"
#include "output/chart/paper_figure_svg.hpp"
#include "output/csv/csv_line.hpp"
#include "output/drawing/mechanism_figures.hpp"
#include "output/report/cam_texts.hpp"
#include "output/words/shown_units.hpp"
#include "studies/check/check_cam.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using units::degree, units::millimetre;

constexpr int left_wall = 0, right_wall = 1;  // stations of the mechanism

/// Both walls at the same cam angles.
struct Walls {
    MechanismProfile left, right;
};

std::string csv_of_walls(const Walls& walls) {
    std::string text =
        "theta_deg,s_mm,middle_x_mm,middle_y_mm,left_x_mm,left_y_mm,right_x_mm,right_y_mm,"
        "pressure_angle_deg,middle_radius_mm,regularity_left,regularity_right\n";
    for (std::size_t i = 0; i < walls.left.points.size(); ++i) {
        const MechanismPoint &left = walls.left.points[i], &right = walls.right.points[i];
        CsvLine line;
        line.number(left.theta / degree).number(walls.left.outputs[i] / millimetre);
        for (const Eigen::Vector3d& place : {left.pitch, left.contact, right.contact})
            line.number(place.x() / millimetre).number(place.y() / millimetre);
        line.number(left.pressure_angle / degree).number(1.0 / (left.pitch_curvature * millimetre));
        line.number(left.regularity).number(right.regularity);
        text += line.finish();
    }
    return text;
}

template <class Place>
PaperSeries path(const std::string& title, const MechanismProfile& profile, double factor,
                 const Place& place) {
    PaperSeries series{title, {}, {}};
    for (const MechanismPoint& point : profile.points) {
        series.x.push_back(factor * place(point).x());
        series.y.push_back(factor * place(point).y());
    }
    return series;
}

std::string drawing_of(const Walls& walls, const std::string& title, const ShownUnit& length) {
    PaperFigure figure{"guide",
                       title + ": the guide in its body",
                       fmt::format("x ({})", length.name),
                       fmt::format("y ({})", length.name),
                       {}};
    figure.equal_scales = true;
    const auto contact = [](const MechanismPoint& point) { return point.contact; };
    figure.series.push_back(path("left wall", walls.left, length.factor, contact));
    figure.series.push_back(path("right wall", walls.right, length.factor, contact));
    figure.series.push_back(path("roller's centre", walls.left, length.factor,
                                 [](const MechanismPoint& point) { return point.pitch; }));
    figure.series.push_back({"body's pivot", {0.0}, {0.0}, true});
    return paper_figure_svg(figure);
}

}  // namespace

std::vector<std::string> guide_texts(const Solution& solution, const CamFileOptions& options) {
    const MotionChain motion = cam_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const int count = options.points.value_or(default_profile_points(motion, scale));
    const DrivenMechanism& mechanism = solution.cam->cam;
    const Walls walls{mechanism_profile(mechanism, motion, scale, count, left_wall),
                      mechanism_profile(mechanism, motion, scale, count, right_wall)};
    const std::string title = solution.scene.title.empty() ? "Inverse cam" : solution.scene.title;
    return {csv_of_walls(walls), drawing_of(walls, title, shown_units(solution.scene).length),
            pressure_angle_svg(solution, walls.left)};
}

}  // namespace camopt
