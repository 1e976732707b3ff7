// SPDX-License-Identifier: MIT
#include "benchmarks/papers/polyline_check.hpp"

#include "core/deadline.hpp"

namespace camopt {

namespace {

using Eigen::Vector2d;

double turned_angle(const Vector2d& point) {
    return std::atan2(point.y(), point.x());
}

/// Where the circle of this radius about the pivot crosses the polyline first.
double polyline_angle(std::span<const Vector2d> points, double distance) {
    const auto beyond = std::ranges::find_if(points, [&](const Vector2d& p) { return p.norm() >= distance; });
    if (beyond == points.end()) return std::nan("");
    if (beyond == points.begin()) return beyond->norm() == distance ? turned_angle(*beyond) : std::nan("");
    const Vector2d &from = *(beyond - 1), run = *beyond - from;
    const double a = run.squaredNorm(), b = from.dot(run), c = from.squaredNorm() - distance * distance;
    const double part =
        -c / (b + std::sqrt(b * b - a * c));  // c <= 0: the positive root without cancellation
    return turned_angle(from + part * run);
}

}  // namespace

GuideCheckResult polyline_check(const GuideCheckInput& input) {
    const Stopwatch watch;
    GuideCheckResult result;
    result.points = static_cast<int>(input.points.size());
    for (int i = 0; i < input.places; ++i) {
        const double distance = input.begin + (input.end - input.begin) * i / (input.places - 1);
        const double deviation = std::abs(polyline_angle(input.points, distance) - input.designed(distance));
        if (deviation <= result.deviation) continue;
        result.deviation = !std::isnan(deviation) ? deviation : std::numeric_limits<double>::infinity();
        result.distance = distance;
        if (std::isnan(deviation)) break;
    }
    result.seconds = watch.seconds();
    return result;
}

}  // namespace camopt
