// SPDX-License-Identifier: MIT
#include "output/csv/profile_csv.hpp"
#include "output/drawing/mechanism_figures.hpp"
#include "output/drawing/mechanism_svg.hpp"
#include "output/report/cam_texts.hpp"
#include "studies/check/check_cam.hpp"

namespace camopt {

std::vector<std::string> linkage_texts(const Solution& solution, const CamFileOptions& options) {
    const MotionChain motion = drawn_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const int count = options.points.value_or(default_profile_points(motion, scale));
    const DrivenMechanism& mechanism = solution.cam->cam;
    const MechanismProfile profile = mechanism_profile(mechanism, motion, scale, count);
    return {profile_csv(profile, {.swings = mechanism.formulas->swings(), .loads = {}}),
            mechanism_svg(solution, motion), pressure_angle_svg(solution, profile),
            curvature_svg(solution, profile)};
}

}  // namespace camopt
