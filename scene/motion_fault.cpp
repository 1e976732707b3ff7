// SPDX-License-Identifier: MIT
// What must hold between the members of a motion.
#include "core/range.hpp"
#include "core/units.hpp"
#include "scene/scene_faults.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt {
namespace {

/// Members that mean nothing in a motion of this type.
Fault type_fault(const MotionSpec& motion) {
    const auto wrong = [&](const char* member, std::string_view what, const char* allowed) {
        return SceneFault{member, fmt::format("{} in a motion of type \"{}\"", what, name_of(motion.type)),
                          allowed};
    };
    const bool program = motion.type == MotionType::program;
    if (motion.type != MotionType::rr && motion.return_angle)
        return wrong("motion.return_angle", "a return", "only in type \"RR\"");
    if (program && motion.symmetric)
        return wrong("motion.symmetric", "true", "false, or type \"DRD\" or \"RR\"");
    if (program && !motion.via.empty())
        return wrong("motion.via", "exact points", "only in type \"DRD\" or \"RR\"");
    if (!program && !motion.segments.empty())
        return wrong("motion.segments", "segments", "only in type \"program\"");
    if (!program && !motion.closed) return wrong("motion.closed", "false", "only in type \"program\"");
    return std::nullopt;
}

Fault return_fault(const MotionSpec& motion) {
    if (motion.type != MotionType::rr) return std::nullopt;
    const double total = motion.rise + motion.return_angle.value_or(motion.rise);
    if (!Range::above_up_to(0.0, units::turn).contains(total))
        return SceneFault{"motion.return_angle", fmt::format("{} rad for rise and return together", total),
                          fmt::format("at most a whole turn, {} rad", units::turn)};
    if (motion.symmetric && std::abs(motion.length() - 2.0) > same_place)
        return SceneFault{"motion.symmetric", "true with a return unlike the rise",
                          "false, or equal angles for rise and return"};
    return std::nullopt;
}

Fault via_fault(const MotionSpec& motion) {
    const Range inside = Range::between(0.0, motion.length());
    for (std::size_t i = 0; i < motion.via.size(); ++i) {
        const SetPoint& point = motion.via[i];
        const std::string member = fmt::format("motion.via[{}]", i);
        if (!inside.contains(point.at))
            return SceneFault{member + ".at", fmt::format("{}", point.at), inside.number_text()};
        for (std::size_t j = 0; j < i; ++j)
            if (std::abs(motion.via[j].at - point.at) <= same_place)
                return SceneFault{member + ".at", fmt::format("{}, the place of motion.via[{}]", point.at, j),
                                  "one point at a place"};
        if (!point.displacement && !point.velocity && !point.acceleration)
            return SceneFault{member, "no value", "at least one of displacement, velocity, acceleration"};
        for (const auto& [name, value] :
             {std::pair{"displacement", point.displacement}, std::pair{"velocity", point.velocity},
              std::pair{"acceleration", point.acceleration}})
            if (value && !std::isfinite(*value))
                return SceneFault{fmt::format("{}.{}", member, name), fmt::format("{}", *value),
                                  Range{}.number_text()};
    }
    return std::nullopt;
}

}  // namespace

Fault motion_fault(const MotionSpec& motion) {
    if (Fault fault = type_fault(motion)) return fault;
    if (motion.type == MotionType::program) return program_fault(motion);
    if (Fault fault = return_fault(motion)) return fault;
    return via_fault(motion);
}

}  // namespace camopt
