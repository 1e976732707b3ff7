// SPDX-License-Identifier: MIT
#include "output/csv/profile_csv.hpp"
#include "output/drawing/mechanism_figures.hpp"
#include "output/drawing/mechanism_svg.hpp"
#include "output/report/cam_texts.hpp"
#include "studies/check/check_cam.hpp"

namespace camopt {

std::vector<std::string> linkage_texts(const Solution& solution, const CamFileOptions& options) {
    const MotionChain motion = cam_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const int count = options.points.value_or(default_profile_points(motion, scale));
    const DrivenMechanism& mechanism = solution.cam->cam;
    const MechanismProfile profile = mechanism_profile(mechanism, motion, scale, count);
    const std::string title = solution.scene.title.empty() ? "Cam and linkage" : solution.scene.title;
    return {profile_csv(profile, {.swings = mechanism.formulas->swings()}),
            mechanism_svg({mechanism, motion, scale}, title), pressure_angle_svg(solution, profile),
            curvature_svg(solution, profile)};
}

}  // namespace camopt
