// SPDX-License-Identifier: MIT
#include "profiles/inverse/inverse_spec.hpp"

#include <array>
#include <cstddef>

namespace camopt {

const char* name_of_number(InverseNumber value) {
    static constexpr std::array<const char*, inverse_number_count> names = {
        "roller_radius", "roller_rest",    "roller_end",     "roller_angle",  "roller_from", "pin_distance",
        "pin_angle",     "rocker_pivot_x", "rocker_pivot_y", "feeder_offset", "feeder_start"};
    return names[static_cast<std::size_t>(value)];
}

CamSpec blank_inverse_spec() {
    CamSpec spec;
    spec.type = inverse_type;
    for (int i = 0; i < inverse_number_count; ++i) {
        const auto number = static_cast<InverseNumber>(i);
        const bool angle = number == InverseNumber::roller_angle || number == InverseNumber::pin_angle;
        spec.dimensions.push_back({name_of_number(number), {}, angle});
    }
    return spec;
}

}  // namespace camopt
