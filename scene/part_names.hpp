// SPDX-License-Identifier: MIT
// The parts of a scene by name: as they are edited, "motion.segments[1].to", and as a person reads them,
// "segment 2".
#pragma once

#include "core/unit.hpp"

#include <concepts>

namespace camopt {

/// "motion" + "type" = "motion.type"; at the top level just the key.
[[nodiscard]] inline std::string joined_key(std::string_view table, std::string_view key) {
    std::string joined(table);
    if (!joined.empty()) joined += '.';
    return joined.append(key);
}

/// An entry of a list, or its member: "axis[0]", "axis[0].phase".
[[nodiscard]] std::string entry_key(std::string_view list, std::integral auto index,
                                    std::string_view member = {}) {
    std::string key(list);
    key.append("[").append(std::to_string(index)).append("]");
    return member.empty() ? key : joined_key(key, member);
}

/// "motion.segments[1]", "motion.segments[1].to"
[[nodiscard]] std::string segment_key(std::integral auto index, std::string_view member = {}) {
    return entry_key("motion.segments", index, member);
}

/// Of an angle that was searched, as an entry of the design: "motion.segments[1].angle_rad".
[[nodiscard]] std::string searched_angle_key(std::integral auto segment) {
    return segment_key(segment, "angle").append(unit_named<"rad">.suffix);
}

/// As a person counts: "segment 2" is motion.segments[1].
[[nodiscard]] inline std::string segment_words(std::size_t index) {
    return "segment " + std::to_string(index + 1);
}

/// What a key in a list of the motion names, numbered from 1: "motion.segments[1].via[0].velocity_mm_deg" is
/// "velocity of set point 1 of segment 2", "motion.segments[1].end.velocity" "velocity at the end of segment
/// 2", "motion.via[0]" "set point 1".
[[nodiscard]] std::string listed_words(std::string_view key);

}  // namespace camopt
