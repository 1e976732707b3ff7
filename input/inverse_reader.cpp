// SPDX-License-Identifier: MIT
#include "input/inverse_reader.hpp"

#include "scene/inverse_spec.hpp"

#include <fmt/format.h>

#include <optional>

namespace camopt::input {
namespace {

using enum InverseNumber;

/// What a scene need not say.
std::optional<double> default_of(InverseNumber number) {
    if (number == pin_angle || number == rocker_pivot_y) return 0.0;
    return std::nullopt;
}

void read_one(const SceneSource& source, InverseNumber number, Dimension& target) {
    const std::string name = name_of_number(number);
    if (const auto given = source.find("cam", name)) {
        target = given->dimension();
        return;
    }
    for (const KeyRow& row : scene_keys()) {
        if (row.table != "cam" || row.name != name) continue;
        const Spelling& spelling = row.spellings.front();
        const std::string key = joined_key("cam", row.key(spelling));
        const std::optional<double> value = default_of(number);
        if (!value)
            source.fail(source.table("cam")->place, key,
                        fmt::format("missing for an inverse cam; allowed: {}", row.allowed(spelling)));
        target = *value;
        target.key = key;
        target.unit = spelling.factor;
    }
}

}  // namespace

MechanismSpec read_inverse(const SceneSource& source, const MotionSpec& motion) {
    if (motion.lift_is_angle)
        source.fail_member(
            "cam.type",
            "found \"inverse\" where the lift is an angle; allowed: motion.lift_mm, motion.lift_in or "
            "motion.lift_m, the stroke of its feeder");
    if (motion.type != MotionType::drd)
        source.fail_member(
            "cam.type", fmt::format("found \"inverse\" with the motion \"{}\"; allowed: the motion \"DRD\"",
                                    name_of(motion.type)));
    MechanismSpec spec = inverse_spec();
    for (int i = 0; i < inverse_number_count; ++i)
        read_one(source, static_cast<InverseNumber>(i), spec.dimensions[static_cast<std::size_t>(i)].value);
    return spec;
}

}  // namespace camopt::input
