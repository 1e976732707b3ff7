// SPDX-License-Identifier: MIT
#include "studies/check/forward_check_input.hpp"

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double same_point = 1e-9;       // of the base radius: two points are one
constexpr double rounding = 1e-10;        // of a length: a cut this deep is none
constexpr double gaps_in_roller = 0.125;  // of its radius: between points this close a roller sinks by 0.2 %

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

TouchingFollower::TouchingFollower(const FollowerGeometry& follower)
    : swings_(follower.swings),
      flat_(follower.contact == ContactKind::flat),
      roller_(follower.roller_radius),
      offset_(follower.offset),
      distance_(follower.pivot_distance),
      arm_(follower.arm),
      face_(follower.face_offset),
      start_(follower.rest_position()) {}

double TouchingFollower::lift_on(const Vector2d& point) const {
    if (!swings_ && flat_) return point.y();
    if (!swings_) {
        const double across = point.x() - offset_, square = roller_ * roller_ - across * across;
        return square >= 0.0 ? point.y() + std::sqrt(square) : -infinity;
    }
    // In the triangle pivot, point, roller centre; seen from the pivot, from the line to the cam centre
    // upwards.
    const double away = std::hypot(distance_ - point.x(), point.y());
    const double point_angle = std::atan2(point.y(), distance_ - point.x());
    if (flat_) return away > std::abs(face_) ? point_angle + std::asin(face_ / away) : -infinity;
    const double cosine = (arm_ * arm_ + away * away - roller_ * roller_) / (2.0 * arm_ * away);
    return std::abs(cosine) <= 1.0 ? point_angle + std::acos(cosine) : -infinity;
}

double TouchingFollower::lift_under(const Vector2d& point) const {
    if (!(point.y() > 0.0)) return infinity;
    if (!swings_) {
        const double across = point.x() - offset_, square = roller_ * roller_ - across * across;
        return square >= 0.0 ? point.y() - std::sqrt(square) : infinity;
    }
    const double away = std::hypot(distance_ - point.x(), point.y());
    const double point_angle = std::atan2(point.y(), distance_ - point.x());
    const double cosine = (arm_ * arm_ + away * away - roller_ * roller_) / (2.0 * arm_ * away);
    return std::abs(cosine) <= 1.0 ? point_angle - std::acos(cosine) : infinity;
}

StandingFollower TouchingFollower::standing_at(double lift) const {
    if (!swings_ && flat_) return {false, {0.0, lift}, {0.0, 1.0}, {0.0, 0.0}, rounding * lift};
    const double square = roller_ * roller_ * (1.0 - rounding);
    if (!swings_) return {true, {offset_, lift}, {0.0, 0.0}, {0.0, 0.0}, square};
    const Vector2d pivot(distance_, 0.0), arm(-std::cos(lift), std::sin(lift)), swing(arm.y(), -arm.x());
    if (flat_) return {false, pivot - face_ * swing, swing, arm, rounding * distance_};
    return {true, pivot + arm_ * arm, {0.0, 0.0}, {0.0, 0.0}, square};
}

double TouchingFollower::lever() const {
    if (!swings_) return 1.0;
    return flat_ ? distance_ : arm_;
}

double TouchingFollower::widest_gap() const {
    return roller_ > 0.0 ? gaps_in_roller * roller_ : infinity;
}

}  // namespace camopt
