// SPDX-License-Identifier: MIT
#include "profiles/inverse/node_method.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace camopt {

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
