// SPDX-License-Identifier: MIT
#include "benchmarks/papers/paper_guide.hpp"

#include "benchmarks/papers/guided_feeder.hpp"
#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

using Eigen::Vector2d;

G1GuideShape g1_guide_shape(const G1GuideDimensions& d) {
    const double sum = d.first_radius + d.second_radius;
    const double sine = std::sin(d.end_angle), cosine = std::cos(d.end_angle);
    const double alpha =
        d.end_angle + std::acos((d.second_radius - d.line_end * sine + d.first_radius * cosine) / sum);
    return {alpha, Vector2d(d.line_end + sum * std::sin(alpha), d.first_radius - sum * std::cos(alpha))};
}

Guide make_g1_guide(const G1GuideDimensions& d) {
    const auto positive = [](const char* name, double value) {
        if (!(value > 0.0))
            throw InputError(fmt::format("{} of the guide is {}; it must be > 0", name, value));
    };
    positive("the end of the first line", d.line_end);
    positive("the first radius", d.first_radius);
    positive("the second radius", d.second_radius);
    positive("the begin", d.begin);
    if (!(d.end_angle > 0.0 && d.end_angle < 0.5 * std::numbers::pi))
        throw InputError(
            fmt::format("the end angle of the guide is {} rad; it must be > 0 and < pi / 2", d.end_angle));
    const G1GuideShape shape = g1_guide_shape(d);
    if (!std::isfinite(shape.middle_angle))
        throw InputError(
            fmt::format("no arcs of radius {} and {} m join the line that ends at {} m to one at {} rad "
                        "through the pivot",
                        d.first_radius, d.second_radius, d.line_end, d.end_angle));
    const Vector2d outwards(std::cos(d.end_angle), std::sin(d.end_angle));
    const Vector2d corner(d.line_end, 0.0), first_center(d.line_end, d.first_radius);
    const Vector2d joint =
        first_center + d.first_radius * Vector2d(std::sin(shape.middle_angle), -std::cos(shape.middle_angle));
    const Vector2d last = shape.second_center + d.second_radius * Vector2d(-outwards.y(), outwards.x());
    return Guide({GuideLine{Vector2d(d.begin, 0.0), corner}, GuideArc{corner, joint, first_center},
                  GuideArc{joint, last, shape.second_center}, GuideLine{last, d.end * outwards}});
}

namespace {

/// The difference that is smaller: exact on a joint means either side.
double nearer_side(double found, double left, double right) {
    return std::min(std::abs(found - left), std::abs(found - right));
}

}  // namespace

std::vector<NodeRow> node_method(const Guide& guide, const RollerStroke& stroke, int nodes) {
    if (nodes < 3)
        throw InputError(fmt::format("{} nodes were requested; central differences need at least 3", nodes));
    const double step = (stroke.end - stroke.begin) / (nodes - 1);
    std::vector<NodeRow> rows(static_cast<std::size_t>(nodes));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].time = i + 1 == rows.size() ? stroke.end : stroke.begin + step * static_cast<double>(i);
        const Eigen::Vector2d point = guide.at(state_of(stroke, rows[i].time).distance).position;
        rows[i].body.angle = -std::atan2(point.y(), point.x());
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double before = rows[i == 0 ? 0 : i - 1].body.angle;
        const double after = rows[std::min(i + 1, rows.size() - 1)].body.angle;
        rows[i].body.velocity = (after - before) / (2.0 * step);
        rows[i].body.acceleration = (after - 2.0 * rows[i].body.angle + before) / (step * step);
    }
    return rows;
}

NodeMethodError node_method_error(const Guide& guide, const RollerStroke& stroke, int nodes) {
    const std::vector<NodeRow> rows = node_method(guide, stroke, nodes);
    const double step = (stroke.end - stroke.begin) / (nodes - 1);
    std::vector<double> joints;
    for (std::size_t i = 1; i + 1 < guide.joints().size(); ++i)
        joints.push_back(time_at(stroke, guide.joints()[i]));
    NodeMethodError error;
    for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
        const RollerState roller = state_of(stroke, rows[i].time);
        const BodyMotion left = body_on_guide(guide, roller, Side::left),
                         right = body_on_guide(guide, roller);
        const double velocity = nearer_side(rows[i].body.velocity, left.velocity, right.velocity);
        const double acceleration =
            nearer_side(rows[i].body.acceleration, left.acceleration, right.acceleration);
        if (velocity > error.velocity) {
            error.velocity = velocity;
            error.velocity_time = rows[i].time;
        }
        if (acceleration > error.acceleration) {
            error.acceleration = acceleration;
            error.acceleration_time = rows[i].time;
        }
        const bool away = std::ranges::none_of(
            joints, [&](double joint) { return std::abs(joint - rows[i].time) <= step; });
        if (away) error.acceleration_away = std::max(error.acceleration_away, acceleration);
    }
    return error;
}

}  // namespace camopt
