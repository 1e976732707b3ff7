// SPDX-License-Identifier: MIT
#include "output/drawing/biarc.hpp"

#include <cmath>
#include <limits>

namespace camopt {

namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

Arc arc_between(const DirectedPoint& start, const Vector2d& end) {
    const Vector2d chord = end - start.position;
    // The chord turns from the start's direction by half the arc's angle.
    const double half_angle = std::atan2(cross(start.direction, chord), start.direction.dot(chord));
    const double length = chord.norm();
    const double curvature = length > 0.0 ? 2.0 * std::sin(half_angle) / length : 0.0;
    return {start, end, std::tan(0.5 * half_angle), curvature};
}

std::array<Arc, 2> biarc(const DirectedPoint& start, const DirectedPoint& end) {
    const Vector2d v = end.position - start.position;
    const double along = v.dot(start.direction + end.direction), square = v.squaredNorm();
    const double turned = (end.direction - start.direction).squaredNorm();  // 2 (1 − c), without cancellation
    const double control = square / (along + std::sqrt(along * along + turned * square));
    const Vector2d first = start.position + control * start.direction;
    const Vector2d last = end.position - control * end.direction;
    const DirectedPoint joint{0.5 * (first + last), (last - first).normalized()};
    return {arc_between(start, joint.position), arc_between(joint, end.position)};
}

double distance_along_normal(const std::array<Arc, 2>& pair, const Vector2d& point, const Vector2d& normal) {
    const DirectedPoint& joint = pair[1].start;
    const Arc& arc = joint.direction.dot(point - joint.position) < 0.0 ? pair[0] : pair[1];
    // With x along the arc's first direction and y to its left: curvature/2 (x² + y²) = y on its circle.
    const Vector2d from = point - arc.start.position;
    const double a = 0.5 * arc.curvature * normal.squaredNorm();
    const double b = arc.curvature * from.dot(normal) - cross(arc.start.direction, normal);
    const double c = 0.5 * arc.curvature * from.squaredNorm() - cross(arc.start.direction, from);
    const double discriminant = b * b - 4.0 * a * c;
    if (!(discriminant >= 0.0)) return std::numeric_limits<double>::infinity();
    const double denominator = std::abs(b) + std::sqrt(discriminant);
    const double distance = std::abs(2.0 * c / denominator);
    return std::isfinite(distance) ? distance : std::numeric_limits<double>::infinity();
}

}  // namespace camopt
