// SPDX-License-Identifier: MIT
#include "profiles/spatial/spatial_spec.hpp"

#include "core/errors.hpp"

#include <array>
#include <cstddef>

namespace camopt {

using enum SpatialFollower;

const char* name_of(SpatialFollower value) {
    switch (value) {
        case barrel:
            return "barrel";
        case cylindrical_rotating:
            return "cylindrical_rotating";
        case cylindrical_translating:
            break;
    }
    return "cylindrical_translating";
}

const char* name_of_number(SpatialNumber value) {
    static constexpr std::array<const char*, spatial_number_count> names = {
        "roller_radius", "arm_length", "center_distance", "lateral_offset", "axial_offset",
        "roller_length", "start"};
    return names[static_cast<std::size_t>(value)];
}

CamSpec blank_spatial_spec(SpatialFollower follower) {
    CamSpec spec;
    spec.type = follower == barrel ? barrel_type : cylindrical_type;
    if (follower != barrel)
        spec.choices["follower"] = follower == cylindrical_rotating ? "rotating" : "translating";
    for (int i = 0; i < spatial_number_count; ++i) {
        const auto number = static_cast<SpatialNumber>(i);
        spec.dimensions.push_back(
            {name_of_number(number), {}, number == SpatialNumber::start && swings(follower)});
    }
    return spec;
}

SpatialFollower spatial_follower(const CamSpec& spec) {
    if (spec.type == barrel_type) return barrel;
    const auto choice = spec.choices.find("follower");
    if (spec.type == cylindrical_type && choice != spec.choices.end()) {
        if (choice->second == "rotating") return cylindrical_rotating;
        if (choice->second == "translating") return cylindrical_translating;
    }
    throw InputError(
        "a mechanism of type \"" + spec.type +
        "\"; allowed: \"barrel\", or \"cylindrical\" with a follower \"rotating\" or \"translating\"");
}

}  // namespace camopt
