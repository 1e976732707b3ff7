// SPDX-License-Identifier: MIT
#include "profiles/inverse/inverse_feeder.hpp"

#include "core/word_of.hpp"
#include "profiles/inverse/inverse_formulas.hpp"

namespace camopt {

RollerState state_of(const RollerStroke& stroke, double time) {
    const double since = time - stroke.reference;
    return {stroke.position + since * (stroke.velocity + 0.5 * stroke.acceleration * since),
            stroke.velocity + stroke.acceleration * since, stroke.acceleration};
}

double time_at(const RollerStroke& stroke, double distance) {
    constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
    const double a = 0.5 * stroke.acceleration, b = stroke.velocity, c = stroke.position - distance;
    const double slack = 1e-9 * (stroke.end - stroke.begin);
    const auto inside = [&](double since) {
        const double time = stroke.reference + since;
        return time >= stroke.begin - slack && time <= stroke.end + slack;
    };
    const double root = std::sqrt(b * b - 4.0 * a * c);  // NaN: never
    const double sum = -0.5 * (b + std::copysign(root, b));
    double found = nowhere;
    for (const double since : {a != 0.0 ? sum / a : nowhere, sum != 0.0 ? c / sum : nowhere})
        if (inside(since)) found = stroke.reference + since;
    return std::clamp(found, stroke.begin, stroke.end);
}

using Eigen::Vector2d;

namespace {

// Relative to L1: for a smaller distance the pin's direction from the rocker's pivot is ill-conditioned.
constexpr double least_reach = 1e-9;
// |cos phi| below this: the feeder would be 10⁹ offsets away.
constexpr double least_cosine = 1e-9;

double angle_of(const Vector2d& direction) {
    return std::atan2(direction.y(), direction.x());
}

/// The angle plus full revolutions, nearest to `reference`.
double counted_on(double angle, double reference) {
    return reference + std::remainder(angle - reference, 2.0 * std::numbers::pi);
}

}  // namespace

std::string_view name_of(InverseFault fault) {
    return word_of<InverseFault::roller_at_rest>(
        fault, {"none", "pin_on_rocker_pivot", "rocker_along_feeder", "rocker_misses_pin",
                "pin_at_dead_point", "roller_at_rest"});
}

FeederMotion feeder_motion(const FeederLinkage& linkage, const BodyMotion& body) {
    FeederMotion motion;
    motion.pin = pin_at(linkage, body.angle);
    const Vector2d across(-motion.pin.y(), motion.pin.x());
    motion.pin_velocity = body.velocity * across;
    motion.pin_acceleration = body.acceleration * across - body.velocity * body.velocity * motion.pin;
    const Vector2d arm = motion.pin - linkage.rocker_pivot;
    motion.rocker_reach = arm.norm();
    if (!(motion.rocker_reach > least_reach * linkage.pin_distance)) {
        motion.fault = InverseFault::pin_on_rocker_pivot;
        return motion;
    }
    const double reach = motion.rocker_reach;
    motion.rocker_angle = counted_on(angle_of(arm), angle_of(pin_at(linkage, 0.0) - linkage.rocker_pivot));
    const Vector2d along = arm / reach, left(-along.y(), along.x());
    // The same as the formulas of the header: the pin's motion in the rocker's directions.
    motion.rocker_velocity = motion.pin_velocity.dot(left) / reach;
    motion.reach_velocity = motion.pin_velocity.dot(along);
    motion.rocker_acceleration =
        (motion.pin_acceleration.dot(left) - 2.0 * motion.reach_velocity * motion.rocker_velocity) / reach;
    motion.reach_acceleration =
        motion.pin_acceleration.dot(along) + reach * motion.rocker_velocity * motion.rocker_velocity;
    if (!(std::abs(along.x()) > least_cosine)) {
        motion.fault = InverseFault::rocker_along_feeder;
        return motion;
    }
    const double tangent = along.y() / along.x(), squared = along.x() * along.x();
    const double turning = motion.rocker_velocity, offset = linkage.feeder_offset;
    motion.feeder = {linkage.rocker_pivot.y() + offset * tangent, offset * turning / squared,
                     offset * (motion.rocker_acceleration + 2.0 * turning * turning * tangent) / squared};
    return motion;
}

BodyResult body_motion(const FeederLinkage& linkage, const FollowerState& feeder) {
    const auto back =
        inverse::backwards<double>(inverse::numbers_of<double>(linkage), inverse::branch_of(linkage),
                                   {feeder.s, feeder.velocity, feeder.acceleration});
    BodyResult result;
    if (!(back.discriminant > 0.0) || !(back.reach > least_reach * linkage.pin_distance)) {
        result.fault = InverseFault::rocker_misses_pin;
    } else if (!(std::abs(back.along) > least_reach * linkage.pin_distance)) {
        result.fault = InverseFault::pin_at_dead_point;
    } else {
        const double angle = std::atan2(back.pin_y, back.pin_x) - linkage.pin_angle;
        result.body = {counted_on(angle, 0.0), back.velocity, back.acceleration};
    }
    return result;
}

GuideNode wanted_guide(const FeederLinkage& linkage, const RollerState& roller, const FollowerState& feeder) {
    const BodyResult back = body_motion(linkage, feeder);
    GuideNode result;
    result.fault = back.fault;
    if (result.fault == InverseFault::none && !(std::abs(roller.velocity) > 0.0))
        result.fault = InverseFault::roller_at_rest;
    if (result.fault != InverseFault::none) return result;
    const double slope = -back.body.velocity / roller.velocity;
    result.node = {
        roller.distance, -back.body.angle, slope,
        -(back.body.acceleration + slope * roller.acceleration) / (roller.velocity * roller.velocity)};
    return result;
}

}  // namespace camopt
