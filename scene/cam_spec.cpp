// SPDX-License-Identifier: MIT
#include "scene/cam_spec.hpp"

namespace camopt {

const char* name_of(FollowerType value) {
    switch (value) {
        case FollowerType::translating_roller:
            return "translating_roller";
        case FollowerType::translating_knife:
            return "translating_knife";
        case FollowerType::translating_flat:
            return "translating_flat";
        case FollowerType::oscillating_roller:
            return "oscillating_roller";
        case FollowerType::oscillating_flat:
            break;
    }
    return "oscillating_flat";
}

const char* name_of(Rotation value) {
    return value == Rotation::counterclockwise ? "counterclockwise" : "clockwise";
}

const char* name_of(DimensionIndex value) {
    switch (value) {
        case DimensionIndex::base_radius:
            return "base_radius";
        case DimensionIndex::roller_radius:
            return "roller_radius";
        case DimensionIndex::offset:
            return "offset";
        case DimensionIndex::center_distance:
            return "center_distance";
        case DimensionIndex::arm_length:
            return "arm_length";
        case DimensionIndex::face_offset:
            break;
    }
    return "face_offset";
}

bool has_dimension(FollowerType follower, DimensionIndex dimension) {
    switch (dimension) {
        case DimensionIndex::base_radius:
            return true;
        case DimensionIndex::roller_radius:
            return has_roller(follower);
        case DimensionIndex::offset:
            return follower == FollowerType::translating_roller ||
                   follower == FollowerType::translating_knife;
        case DimensionIndex::center_distance:
            return is_oscillating(follower);
        case DimensionIndex::arm_length:
            return follower == FollowerType::oscillating_roller;
        case DimensionIndex::face_offset:
            break;
    }
    return follower == FollowerType::oscillating_flat;
}

std::string followers_with(DimensionIndex dimension) {
    std::string names;
    for (const FollowerType follower :
         {FollowerType::translating_roller, FollowerType::translating_knife, FollowerType::translating_flat,
          FollowerType::oscillating_roller, FollowerType::oscillating_flat})
        if (has_dimension(follower, dimension))
            names += (names.empty() ? "\"" : " or \"") + std::string(name_of(follower)) + "\"";
    return names;
}

}  // namespace camopt
