// SPDX-License-Identifier: MIT
#include "scene/follower.hpp"

#include <Eigen/Geometry>

namespace camopt {
namespace {

using enum DimensionIndex;

template <class Condition>
std::string names_where(const Condition& condition) {
    std::string names;
    for (const Follower& follower : followers)
        if (condition(follower))
            names += (names.empty() ? "\"" : " or \"") + std::string(follower.name) + "\"";
    return names;
}

}  // namespace

const char* name_of(DimensionIndex value) {
    static constexpr std::array<const char*, dimension_count> names = {
        "base_radius", "roller_radius", "offset", "center_distance", "arm_length", "face_offset"};
    return names[static_cast<std::size_t>(value)];
}

bool is_offset(DimensionIndex value) {
    return value == offset || value == face_offset;
}

// With p = base + roller radius, a centre distance, l arm length, e offset, f face offset:
//   pushed by a roller or an edge: |e| < p        roller on an arm: |a − l| < p < a + l
//   face on an arm: |base + f| < a
// A dimension that a follower does not have is 0.
std::vector<std::vector<SignedDimension>> reach_of(FollowerType type) {
    if (has_dimension(type, offset))
        return {{{offset, 1.0}, {base_radius, -1.0}, {roller_radius, -1.0}},
                {{offset, -1.0}, {base_radius, -1.0}, {roller_radius, -1.0}}};
    if (has_dimension(type, arm_length))
        return {{{center_distance, 1.0}, {arm_length, -1.0}, {base_radius, -1.0}, {roller_radius, -1.0}},
                {{center_distance, -1.0}, {arm_length, 1.0}, {base_radius, -1.0}, {roller_radius, -1.0}},
                {{center_distance, -1.0}, {arm_length, -1.0}, {base_radius, 1.0}, {roller_radius, 1.0}}};
    if (has_dimension(type, face_offset))
        return {{{base_radius, 1.0}, {face_offset, 1.0}, {center_distance, -1.0}},
                {{base_radius, -1.0}, {face_offset, -1.0}, {center_distance, -1.0}}};
    return {};
}

std::string followers_with(DimensionIndex dimension) {
    return names_where([dimension](const Follower& follower) { return follower.has(dimension); });
}

std::string followers_with_face_width() {
    return names_where([](const Follower& follower) { return follower.has_face_width; });
}

Eigen::Vector2d FollowerGeometry::seen(const Eigen::Vector2d& own) const {
    const Eigen::Vector2d turned = turn == 0.0 ? own : Eigen::Rotation2Dd(-turn) * own;
    return {turned.x(), mirrored ? -turned.y() : turned.y()};
}

double FollowerGeometry::position_at(double distance) const {
    const bool flat = contact == ContactKind::flat;
    if (!swings) return flat ? distance : std::sqrt(distance * distance - offset * offset);
    if (flat) return std::asin((distance + face_offset) / pivot_distance);
    return std::acos((pivot_distance * pivot_distance + arm * arm - distance * distance) /
                     (2.0 * pivot_distance * arm));
}

double FollowerGeometry::distance_at(double position) const {
    const bool flat = contact == ContactKind::flat;
    if (!swings) return flat ? position : std::hypot(position, offset);
    if (flat) return pivot_distance * std::sin(position) - face_offset;
    return std::sqrt(pivot_distance * pivot_distance + arm * arm -
                     2.0 * pivot_distance * arm * std::cos(position));
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
