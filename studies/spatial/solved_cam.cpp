// SPDX-License-Identifier: MIT
#include "studies/spatial/solved_cam.hpp"

#include "core/errors.hpp"
#include "profiles/scene_cam.hpp"
#include "profiles/spatial/spatial_mechanism.hpp"
#include "profiles/spatial/spatial_spec.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/spatial/spatial_forward_check.hpp"

#include <algorithm>

namespace camopt {

namespace {

constexpr int section_points = 2000;

}  // namespace

FollowerMotion follower_motion(const Motion& motion, const MotionScale& scale) {
    FollowerMotion result;
    result.state = [&motion, scale](double theta) {
        const double x = std::clamp(theta / scale.unit_angle, motion.begin(), motion.end());
        return state_of(motion.at(x, x < motion.end() ? Side::right : Side::left), scale);
    };
    for (const double x : motion.breakpoints()) result.breakpoints.push_back(scale.unit_angle * x);
    return result;
}

bool has_spatial_cam(const Solution& solution) {
    const std::optional<MechanismSpec> cam = cam_of(solution.scene);
    return cam && is_spatial(*cam);
}

SpatialCam solved_spatial_cam(const Solution& solution) {
    if (!has_spatial_cam(solution) || !solution.cam)
        throw InputError("a barrel or cylindrical cam is needed, and this solution has none");
    const MechanismSpec spec = cam_of(solution.scene).value();
    return spatial_cam(spatial_follower(spec), spec.rotation, solution.cam->cam.dimensions);
}

ForwardCheckReport check_spatial_cam(const Solution& solution, std::optional<int> points) {
    const SpatialCam cam = solved_spatial_cam(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const MotionChain motion = whole_turn(solution);
    const FollowerMotion turn = follower_motion(motion, scale);
    const FlankGrid grid =
        flank_grid(cam, turn, FlankSampling{.sections = 2, .angles = points.value_or(section_points)});
    SpatialForwardCheckInput input;
    input.sections = sections_of(grid);
    input.breaks = grid.breaks;
    input.follower = cam;
    input.designed = [&turn](double theta) { return turn.state(theta).s; };
    input.begin = turn.begin();
    input.end = turn.end();
    const SpatialForwardCheckResult result = spatial_forward_check(input);
    return {result.deviation, result.deviation / scale.lift, result.theta / scale.unit_angle, result.points,
            result.seconds};
}

}  // namespace camopt
