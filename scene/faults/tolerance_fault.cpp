// SPDX-License-Identifier: MIT
// The tolerances of a made cam against the cam, its spring and its lift.
#include "core/text/list_text.hpp"
#include "scene/faults/scene_faults.hpp"
#include "scene/unit_fault.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

constexpr std::array<std::span<const Spelling>, 3> motion_spellings = {
    spellings::profile_error, spellings::slope_error, spellings::acceleration_error};

/// In a unit that the lift has.
Fault foreign_unit(const Scene& scene) {
    for (std::size_t order = 0; order < motion_spellings.size(); ++order) {
        if (!scene.tolerance->motion[order]) continue;
        const std::string member = fmt::format("tolerance.{}", motion_tolerance_names[order]);
        const Spelling written = scene.spelling_of(member, {});
        const KeyNames names{motion_tolerance_names[order], motion_spellings[order]};
        const bool turns = written.unit.starts_with("mdeg") || is_angle_unit(written.unit);
        if (!written.unit.empty() && turns != scene.motion.lift_is_angle)
            return SceneFault{member,
                              fmt::format("the unit \"{}\" where the lift is {}", written.unit,
                                          length_or_angle(scene.motion.lift_is_angle)),
                              keys_text({&names, 1}, [&](const Spelling& one) {
                                  return (one.unit.starts_with("mdeg") || is_angle_unit(one.unit)) ==
                                         scene.motion.lift_is_angle;
                              })};
    }
    return std::nullopt;
}

/// Forces where the lift is a length, moments where it is an angle.
Fault foreign_load(const Scene& scene) {
    const std::array loads = {KeyNames{"preload", spellings::force_or_moment},
                              KeyNames{"spring_rate", spellings::spring_rate}};
    for (const KeyNames& names : loads) {
        const std::string member = fmt::format("tolerance.{}", names.name);
        if (Fault fault = unit_fault(member, scene.spelling_of(member, {}).unit, scene.motion, {&names, 1}))
            return fault;
    }
    return std::nullopt;
}

/// A number that neither the cam nor its spring has.
Fault foreign_number(const Scene& scene) {
    std::vector<std::string> known;
    for (const CamDimension& dimension : scene.cam->dimensions)
        if (const std::string name = written_name(dimension.value); !name.empty()) known.push_back(name);
    if (scene.forces)
        for (const char* const name : {"preload", "spring_rate"}) known.emplace_back(name);
    for (const auto& [name, tolerance] : scene.tolerance->numbers) {
        if (!(tolerance.size >= 0.0) || !std::isfinite(tolerance.size))
            return SceneFault{"tolerance." + name, fmt::format("{}", tolerance.size), "a number >= 0"};
        if (scene.cam->written_as(name) < 0 && std::ranges::find(known, name) == known.end())
            return SceneFault{"tolerance." + name, "a number that this cam does not have",
                              listed(known, " or ")};
    }
    return std::nullopt;
}

}  // namespace

Fault tolerance_fault(const Scene& scene) {
    if (!scene.tolerance) return std::nullopt;
    if (!scene.cam)
        return SceneFault{"tolerance", "tolerances without a cam", "only together with a [cam] table"};
    if (Fault fault = foreign_unit(scene)) return fault;
    if (Fault fault = foreign_number(scene)) return fault;
    if (Fault fault = foreign_load(scene)) return fault;
    if (const std::size_t count = scene.tolerance->numbers.size(); count > most_tolerant_numbers)
        return SceneFault{
            "tolerance", fmt::format("{} numbers", count),
            fmt::format("at most {}: each doubles the cams that a limit is held for", most_tolerant_numbers)};
    return std::nullopt;
}

}  // namespace camopt
