// SPDX-License-Identifier: MIT
#include "studies/check/check_cam.hpp"

#include "core/errors.hpp"
#include "studies/check/forward_check_input.hpp"

namespace camopt {

namespace {

constexpr int follower_points = 2000, linkage_points = 6000;

}  // namespace

MotionScale motion_scale(const Scene& scene) {
    return {scene.motion.lift, scene.motion.unit_angle()};
}

MotionChain whole_turn(const Solution& solution) {
    return solution.whole_turn();
}

MotionChain cam_motion(const Solution& solution) {
    const bool rests = solution.scene.motion.type == MotionType::rr;
    return rests || !solution.motion ? whole_turn(solution) : *solution.motion;
}

ForwardCheckReport check_cam(const Solution& solution, std::optional<int> points) {
    if (!solution.cam) throw InputError("the forward check needs a cam, and this solution has none");
    const DrivenMechanism& cam = solution.cam->cam;
    const MotionChain motion = cam_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const int count = points.value_or(cam.formulas->is_direct() ? follower_points : linkage_points);
    const ForwardCheckResult result = forward_check(forward_check_input(cam, motion, scale, count));
    return {result.deviation, result.relative, result.theta / scale.unit_angle, result.points,
            result.seconds};
}

}  // namespace camopt
