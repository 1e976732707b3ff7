// SPDX-License-Identifier: MIT
#include "core/unit.hpp"

namespace camopt {

const Spelling* unit_of_key(std::string_view key) {
    using Units = std::span<const Spelling>;
    const Spelling* found = nullptr;
    for (const Units units : {Units(spellings::length),
                              Units(spellings::cam_angle),
                              Units(spellings::speed),
                              Units(spellings::frequency),
                              Units(spellings::feed),
                              Units(spellings::vibration),
                              Units(spellings::travel_per_turn),
                              Units(spellings::mass),
                              Units(spellings::inertia),
                              Units(spellings::density),
                              Units(spellings::force_or_moment),
                              Units(spellings::pressure),
                              Units(spellings::spring_rate),
                              Units(spellings::train_spring),
                              Units(spellings::damper),
                              Units(spellings::velocity),
                              Units(spellings::acceleration),
                              Units(spellings::jerk),
                              Units(spellings::profile_error),
                              Units(spellings::slope_error),
                              Units(spellings::acceleration_error)})
        for (const Spelling& one : units)
            if (!one.suffix.empty() && key.ends_with(one.suffix) &&
                (found == nullptr || one.suffix.size() > found->suffix.size()))
                found = &one;
    // "spring_rate_lbf_in", "torque_max_lbf_in": the same end for lbf/in and lbf in.
    constexpr const Spelling& rate = unit_named<"lbf/in">;
    const bool is_rate = key.find("rate") != std::string_view::npos ||
                         key.find("stiffness") != std::string_view::npos ||
                         key.find("spring") != std::string_view::npos;
    return found != nullptr && found->suffix == rate.suffix && is_rate ? &rate : found;
}

bool is_angle_key(std::string_view key) {
    const Spelling* const unit = unit_of_key(key);
    return unit != nullptr && unit->quantity.angle == 1 &&
           Quantity{.angle = 1, .crank = unit->quantity.crank} == unit->quantity;
}

}  // namespace camopt
