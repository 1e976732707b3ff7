// SPDX-License-Identifier: MIT
#include "output/nc/path/nc_path.hpp"

#include <cmath>
#include <numbers>

namespace camopt {

namespace {

constexpr double no_turn = 1e-12;  // rad: an arc that ends where it begins is a whole circle

struct RoundWay {
    double begin_angle, sweep;  // rad, signed
    double begin_radius, end_radius;
};

RoundWay round_way(const Eigen::VectorXd& from, const NcMove& move) {
    const Eigen::Vector2d begin = from.head<2>() - move.arc->center;
    const Eigen::Vector2d end = move.values.head<2>() - move.arc->center;
    const double begin_angle = std::atan2(begin.y(), begin.x());
    double sweep = std::atan2(end.y(), end.x()) - begin_angle;
    const double turn = 2.0 * std::numbers::pi, sense = move.arc->clockwise ? -1.0 : 1.0;
    while (sense * sweep <= no_turn) sweep += sense * turn;
    while (sense * sweep > turn + no_turn) sweep -= sense * turn;
    return {begin_angle, sweep, begin.norm(), end.norm()};
}

}  // namespace

Eigen::VectorXd values_along(const Eigen::VectorXd& from, const NcMove& move, double share) {
    Eigen::VectorXd values = from + share * (move.values - from);
    if (!move.arc) return values;
    const RoundWay way = round_way(from, move);
    const double angle = way.begin_angle + share * way.sweep;
    const double radius = way.begin_radius + share * (way.end_radius - way.begin_radius);
    values.head<2>() = move.arc->center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    return values;
}

double linear_length(const Eigen::VectorXd& from, const NcMove& move) {
    const Eigen::VectorXd way = move.values - from;
    if (!move.arc) return way.head<3>().norm();
    const RoundWay round = round_way(from, move);
    const double around = std::max(round.begin_radius, round.end_radius) * std::abs(round.sweep);
    return std::hypot(around + std::abs(round.end_radius - round.begin_radius), way(2));
}

}  // namespace camopt
