// SPDX-License-Identifier: MIT
#include "scene/unit_fault.hpp"

#include "core/text/quantity_text.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

/// Of an output that swings.
bool turns(std::string_view unit) {
    return is_angle_unit(unit) || unit.starts_with("N m") || unit == "kg m^2" || unit == "lbf in";
}

bool fits(const Spelling& one, bool lift_is_angle) {
    return one.unit.empty() || turns(one.unit) == lift_is_angle;
}

}  // namespace

std::string fitting_keys(std::span<const KeyNames> names, bool lift_is_angle) {
    return keys_text(names, [=](const Spelling& one) { return fits(one, lift_is_angle); });
}

std::optional<SceneFault> unit_fault(std::string_view member, std::string_view unit, const MotionSpec& motion,
                                     std::span<const KeyNames> names) {
    if (unit.empty()) return std::nullopt;
    const bool angle = motion.lift_is_angle;
    if (turns(unit) != angle)
        return SceneFault{std::string(member),
                          fmt::format("the unit \"{}\" where the lift is {}", unit, length_or_angle(angle)),
                          fitting_keys(names, angle)};
    if (motion.speed || !is_unit_of_time(unit)) return std::nullopt;
    const auto by_angle = [&](const Spelling& one) { return fits(one, angle) && !is_unit_of_time(one.unit); };
    return SceneFault{
        std::string(member), fmt::format("the unit \"{}\" without a speed", unit),
        fmt::format("together with motion.speed, or by the cam angle: {}", keys_text(names, by_angle))};
}

}  // namespace camopt
