// SPDX-License-Identifier: MIT
#include "studies/check/touching_follower.hpp"

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double rounding = 1e-10;        // of a length: a cut this deep is none
constexpr double gaps_in_roller = 0.125;  // of its radius: between points this close a roller sinks by 0.2 %

}  // namespace

TouchingFollower::TouchingFollower(const FollowerGeometry& follower)
    : swings_(follower.swings),
      flat_(follower.contact == ContactKind::flat),
      roller_(follower.roller_radius),
      offset_(follower.offset),
      distance_(follower.pivot_distance),
      arm_(follower.arm),
      face_(follower.face_offset),
      start_(follower.rest_position()),
      most_(follower.most_position) {}

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
    const double lift = std::abs(cosine) <= 1.0 ? point_angle + std::acos(cosine) : -infinity;
    return lift < most_ ? lift : -infinity;
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
