// SPDX-License-Identifier: MIT
#include "studies/check/forward_check_input.hpp"

#include "studies/check/touching_follower.hpp"

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double same_point = 1e-9;  // of the base radius: two points are one

Rotation opposite(Rotation rotation) {
    return rotation == Rotation::clockwise ? Rotation::counterclockwise : Rotation::clockwise;
}

/// From the follower's lift to the output; empty: they are the same.
std::function<double(double)> output_of(const FollowerGeometry& follower) {
    if (follower.linkage)
        return [follower, start = follower.rest_position()](double lift) {
            return follower.linkage(follower.arm_angle(start + lift));
        };
    if (follower.falls) return [](double lift) { return -lift; };
    return {};
}

ForwardCheckInput input_of(const DrivenMechanism& mechanism, FollowerGeometry follower, const Motion& motion,
                           const MotionScale& scale) {
    const Rotation rotation = mechanism.formulas->rotation();
    ForwardCheckInput input;
    input.rotation = follower.mirrored ? opposite(rotation) : rotation;
    input.begin = scale.unit_angle * motion.begin();
    input.end = scale.unit_angle * motion.end();
    input.designed = [&motion, scale](double theta) {
        const double x = std::clamp(theta / scale.unit_angle, motion.begin(), motion.end());
        return scale.lift * motion.at(x).derivative[0];
    };
    input.output = output_of(follower);
    input.output_size =
        follower.linkage ? scale.lift : follower.rest_distance / TouchingFollower(follower).lever();
    input.follower = std::move(follower);
    return input;
}

void set_points(ForwardCheckInput& input, const MechanismProfile& profile) {
    input.points.reserve(profile.points.size());
    for (const MechanismPoint& point : profile.points)
        input.points.push_back(input.follower.seen(point.contact.head<2>()));
    input.breaks = profile.breaks;
    const double gap = (input.points.back() - input.points.front()).norm();
    const double base = input.follower.rest_distance - input.follower.roller_radius;
    input.closed = is_whole_turn(input.end - input.begin) && gap < same_point * base;
}

FollowerGeometry checked_follower(const DrivenMechanism& mechanism, int station) {
    std::optional<FollowerGeometry> found = mechanism.formulas->follower(mechanism.dimensions, station);
    if (!found)
        throw InputError("the forward check needs a follower that touches the cam, and this cam has none");
    return *std::move(found);
}

}  // namespace

ForwardCheckInput forward_check_input(const DrivenMechanism& mechanism, const Motion& motion,
                                      const MotionScale& scale, int points) {
    ForwardCheckInput input = input_of(mechanism, checked_follower(mechanism, 0), motion, scale);
    set_points(input, mechanism_profile(mechanism, motion, scale, points));
    return input;
}

ForwardCheckInput side_check_input(const DrivenMechanism& mechanism, const Motion& motion,
                                   const MotionScale& scale, const CheckedSide& side) {
    FollowerGeometry follower = checked_follower(mechanism, side.side);
    follower.roller_radius = side.roller_radius;
    ForwardCheckInput input = input_of(mechanism, std::move(follower), motion, scale);
    input.keep_found = true;
    set_points(input, mechanism_profile(mechanism, motion, scale, side.points, side.side));
    return input;
}

}  // namespace camopt
