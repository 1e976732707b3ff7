// SPDX-License-Identifier: MIT
#include "scene/follower.hpp"

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

}  // namespace camopt
