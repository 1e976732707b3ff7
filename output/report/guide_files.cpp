// SPDX-License-Identifier: MIT
#include "core/units.hpp"
#include "output/csv/csv_line.hpp"
#include "output/drawing/guide_svg.hpp"
#include "output/drawing/mechanism_figures.hpp"
#include "output/report/cam_texts.hpp"
#include "studies/check/check_cam.hpp"

namespace camopt {

namespace {

using units::degree, units::millimetre;

constexpr int left_wall = 0, right_wall = 1;  // stations of the mechanism

std::string csv_of_walls(const GuideWalls& walls) {
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

}  // namespace

std::vector<std::string> guide_texts(const Solution& solution, const CamFileOptions& options) {
    const MotionChain motion = cam_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const int count = options.points.value_or(default_profile_points(motion, scale));
    const DrivenMechanism& mechanism = solution.cam->cam;
    const GuideWalls walls{mechanism_profile(mechanism, motion, scale, count, left_wall),
                           mechanism_profile(mechanism, motion, scale, count, right_wall)};
    return {csv_of_walls(walls), guide_svg(solution, walls), pressure_angle_svg(solution, walls.left)};
}

}  // namespace camopt
