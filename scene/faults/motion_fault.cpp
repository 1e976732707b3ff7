// SPDX-License-Identifier: MIT
// Relations between the members of a motion.
#include "core/numbers/range.hpp"
#include "core/units.hpp"
#include "scene/faults/scene_faults.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt {
namespace {

/// Members without a meaning in a motion of this type.
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
        return wrong("motion.via", "exact points",
                     "only in type \"DRD\" or \"RR\"; a program has them in its segments");
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
                          fmt::format("at most one revolution, {} rad", units::turn)};
    if (motion.symmetric && std::abs(motion.length() - 2.0) > same_place)
        return SceneFault{"motion.symmetric", "true with a return different from the rise",
                          "false, or equal angles for rise and return"};
    return std::nullopt;
}

}  // namespace

Fault motion_fault(const MotionSpec& motion) {
    if (Fault fault = type_fault(motion)) return fault;
    if (Fault fault = motion.type == MotionType::program ? program_fault(motion) : return_fault(motion))
        return fault;
    return set_point_fault(motion);
}

}  // namespace camopt
