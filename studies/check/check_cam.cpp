// SPDX-License-Identifier: MIT
#include "studies/check/check_cam.hpp"

#include "core/errors.hpp"
#include "studies/check/forward_check_input.hpp"

#include <numbers>

namespace camopt {

namespace {

constexpr double whole_turn = 1e-9;  // of a turn: what is left of it is rounding

}  // namespace

MotionScale motion_scale(const Scene& scene) {
    return {scene.motion.lift, scene.motion.unit_angle()};
}

MotionChain cam_motion(const Solution& solution) {
    if (!solution.motion) throw InputError("a cam needs a motion, and this solution has none");
    const MotionChain& motion = *solution.motion;
    const double turn = 2.0 * std::numbers::pi / solution.scene.motion.unit_angle();
    const bool rests =
        solution.scene.motion.type == MotionType::rr && motion.end() < turn * (1.0 - whole_turn);
    if (!rests) return motion;
    std::vector<ChainPart> parts = motion.parts();
    parts.push_back({motion.end(), turn, nullptr, 0.0, 1.0, 0.0, 1.0});
    return MotionChain(std::move(parts));
}

ForwardCheckReport check_cam(const Solution& solution, int points) {
    if (!solution.cam) throw InputError("the forward check needs a cam, and this solution has none");
    const MotionChain motion = cam_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const ForwardCheckResult result =
        forward_check(forward_check_input(solution.cam->cam, motion, scale, points));
    return {result.deviation, result.relative, result.theta / scale.unit_angle, result.points,
            result.seconds};
}

}  // namespace camopt
