// SPDX-License-Identifier: MIT
#include "studies/check/check_cam.hpp"

#include "core/errors.hpp"
#include "studies/check/forward_check_input.hpp"

#include <numbers>

namespace camopt {

namespace {

constexpr double rounded_turn = 1e-9;  // of a turn: what is left of it is rounding
constexpr int follower_points = 2000, linkage_points = 6000;

}  // namespace

MotionScale motion_scale(const Scene& scene) {
    return {scene.motion.lift, scene.motion.unit_angle()};
}

MotionChain whole_turn(const Solution& solution) {
    if (!solution.motion) throw InputError("a cam needs a motion, and this solution has none");
    const MotionChain& motion = *solution.motion;
    const double turn = 2.0 * std::numbers::pi / solution.scene.motion.unit_angle();
    if (motion.end() >= turn * (1.0 - rounded_turn)) return motion;
    const bool returns =
        solution.scene.motion.type == MotionType::rr;  // to 0, not to what rounding left of it
    const double end = returns ? 0.0 : motion.at(motion.end(), Side::left).derivative[0];
    std::vector<ChainPart> parts = motion.parts();
    parts.push_back({motion.end(), turn, nullptr, 0.0, 1.0, end, 1.0});
    return MotionChain(std::move(parts));
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
