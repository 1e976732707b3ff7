// SPDX-License-Identifier: MIT
#include "scene/follower_geometry.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace camopt {

Eigen::Vector2d FollowerGeometry::seen(const Eigen::Vector2d& own) const {
    const Eigen::Vector2d turned = turn == 0.0 ? own : Eigen::Rotation2Dd(-turn) * own;
    return {turned.x(), mirrored ? -turned.y() : turned.y()};
}

double FollowerGeometry::arm_angle(double psi) const {
    return turn + (mirrored ? -1.0 : 1.0) * (std::numbers::pi - psi);
}

FollowerGeometry follower_on_lever(const RollerLever& lever) {
    FollowerGeometry follower;
    follower.swings = true;
    follower.roller_radius = lever.roller_radius;
    follower.pivot_distance = lever.pivot.norm();
    follower.arm = lever.arm;
    follower.turn = std::atan2(lever.pivot.y(), lever.pivot.x());
    const double beta = std::remainder(lever.angle - follower.turn, 2.0 * std::numbers::pi);
    follower.mirrored = beta < 0.0;
    const double a = follower.pivot_distance, l = lever.arm, psi = std::numbers::pi - std::abs(beta);
    follower.rest_distance = std::sqrt(a * a + l * l - 2.0 * a * l * std::cos(psi));
    return follower;
}

}  // namespace camopt
