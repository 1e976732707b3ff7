// SPDX-License-Identifier: MIT
#include "input/peak_limits.hpp"

#include "scene/limit_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt::input {
namespace {

/// `order`: 1 velocity, 2 acceleration, 3 jerk.
std::optional<PeakLimit> read_limit(const SceneSource& source, const MotionSpec& motion,
                                    std::string_view name, int order) {
    const std::optional<Given> given = source.find("limits", name);
    if (!given) return std::nullopt;
    const double number = given->value().as_number();
    PeakLimit limit(number, joined_key("limits", given->member->name), number,
                    std::string(given->spelling->unit));
    if (limit.unit.empty()) return limit;
    if (is_angle_unit(limit.unit) != motion.lift_is_angle)
        source.fail(given->member->place, limit.key,
                    fmt::format("found a limit in {} where the lift is {}; allowed: {}", limit.unit,
                                motion.lift_is_angle ? "an angle" : "a length",
                                motion.lift_is_angle ? "a limit in deg or rad, or a normalised one"
                                                     : "a limit in mm, in or m, or a normalised one"));
    if (!motion.speed)
        source.fail(
            given->member->place, limit.key,
            fmt::format("found a limit in {} without a speed; allowed: together with motion.speed_rpm or "
                        "motion.speed_rad_s",
                        limit.unit));
    limit.normalised = given->number() / (motion.lift * std::pow(*motion.speed / motion.unit_angle(), order));
    return limit;
}

}  // namespace

LimitSpec read_peak_limits(const SceneSource& source, const MotionSpec& motion) {
    LimitSpec limits;
    for (const PeakLimitRow& row : peak_limit_rows())
        row.in(limits) = read_limit(source, motion, row.name(), row.order());
    return limits;
}

}  // namespace camopt::input
