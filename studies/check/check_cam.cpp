// SPDX-License-Identifier: MIT
#include "studies/check/check_cam.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "profiles/disk/disk_mechanism.hpp"
#include "profiles/disk/disk_sides.hpp"
#include "studies/check/forward_check_input.hpp"
#include "studies/check/two_sided_check.hpp"

#include <utility>
#include <vector>

namespace camopt {

namespace {

constexpr double least_dwell = 1e-6;  // rad: a shorter rest of the turn is rounding
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

MotionChain drawn_motion(const Solution& solution) {
    MotionChain motion = cam_motion(solution);
    const bool turns = solution.cam && !solution.cam->cam.formulas->has_guide();
    const double unit_angle = solution.scene.motion.unit_angle();
    const double rest = 0.5 * (units::turn / unit_angle - (motion.end() - motion.begin()));
    if (!turns || solution.scene.motion.type != MotionType::drd || !(rest > least_dwell / unit_angle))
        return motion;
    std::vector<ChainPart> parts = motion.parts();
    const auto dwell = [&](double begin, double end, double height) {
        ChainPart part;
        part.begin = begin;
        part.end = end;
        part.y0 = height;
        return part;
    };
    const double first = motion.at(motion.begin()).derivative[0],
                 last = motion.at(motion.end(), Side::left).derivative[0];
    parts.insert(parts.begin(), dwell(motion.begin() - rest, motion.begin(), first));
    parts.push_back(dwell(motion.end(), motion.end() + rest, last));
    return MotionChain(std::move(parts));
}

std::string open_because(const Solution& solution) {
    const MotionSpec& motion = solution.scene.motion;
    if (motion.type == MotionType::drd) return "no return is given: motion.type is \"DRD\"";
    if (motion.type == MotionType::program && !motion.closed)
        return "the program is not closed: motion.closed is false";
    return "";
}

ForwardCheckReport check_cam(const Solution& solution, std::optional<int> points) {
    if (!solution.cam) throw InputError("the forward check needs a cam, and this solution has none");
    const DrivenMechanism& cam = solution.cam->cam;
    const MotionChain motion = cam_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const int count = points.value_or(cam.formulas->is_direct() ? follower_points : linkage_points);
    if (const std::optional<DiskCam> disk = disk_cam(cam); disk && side_count(*disk) > 1)
        return two_sided_check(cam, motion, scale, count);
    const ForwardCheckResult result = forward_check(forward_check_input(cam, motion, scale, count));
    return {result.deviation, result.relative, result.theta / scale.unit_angle, result.points,
            result.seconds};
}

}  // namespace camopt
