// SPDX-License-Identifier: MIT
#include "scene/written_limits.hpp"

#include "core/errors.hpp"
#include "scene/spellings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

namespace camopt {
namespace {

// Two numbers for one limit agree where they differ by less: far above the rounding of a change of unit, far
// below what anyone would call another limit.
constexpr double same_number = 1e-9;

[[noreturn]] void refuse(std::string_view member, const std::string& found, const std::string& allowed) {
    throw InputError(fmt::format("{}: found {}; allowed: {}", member, found, allowed));
}

/// By the unit, else by what the key ends in, else by the unit's value; null where nothing of it is known.
const Spelling* spelling_of(std::span<const Spelling> known, std::string_view member, std::string_view key,
                            std::string_view unit) {
    for (const Spelling& spelling : known)
        if (unit.empty() ? key == fmt::format("{}{}", member, spelling.suffix) : spelling.unit == unit)
            return &spelling;
    return nullptr;
}

struct PeakLimitRow {
    const char* member;
    std::optional<PeakLimit> LimitSpec::*limit;
    std::span<const Spelling> spellings;
    int order;
};
constexpr std::array<PeakLimitRow, 3> peak_limits = {{
    {"limits.velocity", &LimitSpec::velocity, spellings::velocity_limit, 1},
    {"limits.acceleration", &LimitSpec::acceleration, spellings::acceleration_limit, 2},
    {"limits.jerk", &LimitSpec::jerk, spellings::jerk_limit, 3},
}};

struct CamLimitRow {
    const char* member;
    std::optional<WrittenLimit> LimitSpec::*limit;
    std::span<const Spelling> spellings;
};
constexpr std::array<CamLimitRow, 9> cam_limits = {{
    {"limits.pressure_angle", &LimitSpec::pressure_angle, spellings::angle},
    {"limits.rise_pressure_angle", &LimitSpec::rise_pressure_angle, spellings::angle},
    {"limits.return_pressure_angle", &LimitSpec::return_pressure_angle, spellings::angle},
    {"limits.cam_radius_min", &LimitSpec::cam_radius_min, spellings::length},
    {"limits.concave_radius_min", &LimitSpec::concave_radius_min, spellings::length},
    {"limits.undercut_margin", &LimitSpec::undercut_margin, spellings::plain},
    {"limits.contact_force_min", &LimitSpec::contact_force_min, spellings::force},
    {"limits.torque_max", &LimitSpec::torque_max, spellings::moment},
    {"limits.hertz_pressure_max", &LimitSpec::hertz_pressure_max, spellings::pressure},
}};

/// The unit of the limit; refuses one that it cannot have.
const Spelling& peak_spelling(const PeakLimitRow& row, const PeakLimit& limit, const MotionSpec& motion) {
    const Spelling* const known = spelling_of(row.spellings, row.member, limit.key, limit.unit);
    if (!known && limit.unit.empty()) return row.spellings.front();
    if (!known) {
        std::string units;
        for (const Spelling& spelling : row.spellings.subspan(1))
            units += fmt::format("{}{}", units.empty() ? "" : ", ", spelling.unit);
        refuse(row.member, fmt::format("the unit \"{}\"", limit.unit),
               fmt::format("none (normalised), or {}", units));
    }
    if (known->unit.empty()) return *known;
    const bool angle = known->unit.starts_with("deg") || known->unit.starts_with("rad");
    if (angle != motion.lift_is_angle)
        refuse(row.member,
               fmt::format("a limit in {} where the lift is {}", known->unit,
                           motion.lift_is_angle ? "an angle" : "a length"),
               motion.lift_is_angle ? "a limit in deg or rad, or a normalised one"
                                    : "a limit in mm, in or m, or a normalised one");
    if (!motion.speed)
        refuse(row.member, fmt::format("a limit in {} without a speed", known->unit),
               "a limit in time only where motion.speed is given");
    return *known;
}

void complete(const PeakLimitRow& row, PeakLimit& limit, const MotionSpec& motion) {
    const Spelling& spelling = peak_spelling(row, limit, motion);
    const double scale =
        spelling.unit.empty()
            ? 1.0
            : motion.lift * std::pow(*motion.speed / motion.unit_angle(), row.order) / spelling.factor;
    limit.unit = spelling.unit;
    if (limit.key.empty()) limit.key = fmt::format("{}{}", row.member, spelling.suffix);
    if (!(scale > 0.0) || !std::isfinite(scale)) return;  // validate() says what is wrong with the motion
    if (limit.given == 0.0)
        limit.given = scale == 1.0 ? limit.normalised : as_written(limit.normalised * scale);
    if (limit.normalised == 0.0) limit.normalised = limit.given / scale;
    const double other = limit.normalised * scale;
    if (std::abs(other - limit.given) > same_number * std::max(std::abs(other), std::abs(limit.given)))
        refuse(row.member, fmt::format("normalised {} beside given {}", limit.normalised, limit.given),
               "one of them, or two that say the same");
}

void complete(const CamLimitRow& row, WrittenLimit& limit, bool oscillating) {
    if (!(limit.unit_value > 0.0) || !std::isfinite(limit.unit_value))
        refuse(row.member, fmt::format("unit_value {}", limit.unit_value), "a number > 0");
    const bool moment = row.limit == &LimitSpec::contact_force_min && oscillating;
    const std::string member = moment ? "limits.contact_moment_min" : row.member;
    const std::span<const Spelling> known =
        moment ? std::span<const Spelling>(spellings::moment) : row.spellings;
    const Spelling* spelling = spelling_of(known, member, limit.key, limit.unit);
    if (!spelling && limit.unit.empty() && limit.unit_value != 1.0)
        for (const Spelling& one : known)
            if (one.factor == limit.unit_value) spelling = &one;
    if (!spelling && limit.unit.empty() && limit.key.empty()) spelling = &known.front();
    if (spelling) {  // else it is in a unit of the embedder's own
        limit.unit = spelling->unit;
        limit.unit_value = spelling->factor;
    }
    if (limit.key.empty()) limit.key = fmt::format("{}{}", member, spelling ? spelling->suffix : "");
}

void complete(CamSpec& cam) {
    for (int i = 0; i < dimension_count; ++i) {
        const auto which = static_cast<DimensionIndex>(i);
        Dimension& dimension = cam[which];
        if (!has_dimension(cam.follower, which) || !dimension.key.empty()) continue;
        const Spelling* spelling = std::ranges::find(spellings::length, dimension.unit, &Spelling::factor);
        if (spelling == std::ranges::end(spellings::length)) spelling = std::ranges::begin(spellings::length);
        dimension.key = fmt::format("cam.{}{}", name_of(which), spelling->suffix);
        dimension.unit = spelling->factor;
    }
}

}  // namespace

Scene with_written_limits(Scene scene) {
    for (const PeakLimitRow& row : peak_limits)
        if (auto& limit = scene.limits.*row.limit) complete(row, *limit, scene.motion);
    for (const CamLimitRow& row : cam_limits)
        if (auto& limit = scene.limits.*row.limit)
            complete(row, *limit, scene.cam && is_oscillating(scene.cam->follower));
    if (scene.cam) complete(*scene.cam);
    return scene;
}

}  // namespace camopt
