// SPDX-License-Identifier: MIT
#include "scene/written_limits.hpp"

#include "core/text/list_text.hpp"
#include "scene/cam_mechanism.hpp"
#include "scene/limit_table.hpp"
#include "scene/unit_fault.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

// Two numbers for one limit agree if they differ by less: far above the rounding of a change of unit, far
// below a deliberate difference.
constexpr double same_number = 1e-9;

[[noreturn]] void refuse(std::string_view member, const std::string& found, const std::string& allowed) {
    throw InputError(fmt::format("{}: found {}; allowed: {}", member, found, allowed));
}

/// By the unit, else by the suffix of the key, else by the unit's value; null if none is known.
const Spelling* spelling_of(std::span<const Spelling> known, std::string_view member, std::string_view key,
                            std::string_view unit) {
    for (const Spelling& spelling : known)
        if (unit.empty() ? key == fmt::format("{}{}", member, spelling.suffix) : spelling.unit == unit)
            return &spelling;
    return nullptr;
}

std::string member_of(std::string_view name) {
    return fmt::format("limits.{}", name);
}

/// The unit of the limit; refuses an invalid one.
const Spelling& peak_spelling(const PeakLimitRow& row, const PeakLimit& limit, const MotionSpec& motion) {
    const std::string member = member_of(row.name());
    std::string_view key = limit.key;
    if (row.side != 0 && key.size() > 4) key.remove_suffix(4);  // ".min"
    const Spelling* const known = spelling_of(row.spellings, member_of(row.key_name), key, limit.unit);
    if (!known && limit.unit.empty()) return row.spellings.front();
    if (!known) {
        std::string units;
        for (const Spelling& spelling : row.spellings.subspan(1)) append_item(units, spelling.unit);
        refuse(member, fmt::format("the unit \"{}\"", limit.unit),
               fmt::format("none (normalised), or {}", units));
    }
    const std::array names = {KeyNames{row.key_name, row.spellings}};
    if (const auto fault = unit_fault(member, known->unit, motion, names))
        refuse(fault->member, fault->found, fault->allowed);
    return *known;
}

void complete(const PeakLimitRow& row, PeakLimit& limit, const MotionSpec& motion) {
    const Spelling& spelling = peak_spelling(row, limit, motion);
    const std::string member = member_of(row.name());
    const double scale = one_normalised_peak(motion, row.order(), spelling);
    limit.unit = spelling.unit;
    if (limit.key.empty())
        limit.key = written_limit_key(row.key_name, spelling.suffix, side_of_key(row.side));
    if (!(scale > 0.0) || !std::isfinite(scale)) return;  // validate() reports faults of the motion
    limit.one_normalised = scale;
    if (limit.given == 0.0)
        limit.given = scale == 1.0 ? limit.normalised : as_written(limit.normalised * scale);
    if (limit.normalised == 0.0) limit.normalised = limit.given / scale;
    const double other = limit.normalised * scale;
    if (std::abs(other - limit.given) > same_number * std::max(std::abs(other), std::abs(limit.given)))
        refuse(member, fmt::format("normalised {} together with given {}", limit.normalised, limit.given),
               "one of them, or two equal values");
}

void complete(const LimitRow& row, WrittenLimit& limit, bool oscillating) {
    if (!(limit.unit_value > 0.0) || !std::isfinite(limit.unit_value))
        refuse(member_of(row.name), fmt::format("unit_value {}", limit.unit_value), "a number > 0");
    const bool own = oscillating && row.swinging.name != nullptr;
    const char* const name = own ? row.swinging.name : row.side != nullptr ? row.table : row.name;
    const std::string member = member_of(name);
    const std::span<const Spelling> known = own ? row.swinging.spellings : row.spellings;
    const Spelling* spelling = spelling_of(known, member, limit.key, limit.unit);
    if (!spelling && limit.unit.empty() && limit.unit_value != 1.0)
        for (const Spelling& one : known)
            if (one.factor == limit.unit_value) spelling = &one;
    if (!spelling && limit.unit.empty() && limit.key.empty()) spelling = &known.front();
    if (spelling) {  // else it is in a unit of the embedder
        limit.unit = spelling->unit;
        limit.unit_value = spelling->factor;
    }
    if (limit.key.empty())
        limit.key =
            written_limit_key(name, spelling ? spelling->suffix : "", row.side != nullptr ? row.side : "");
}

}  // namespace

std::string written_limit_key(std::string_view name, std::string_view suffix, std::string_view side) {
    return fmt::format("limits.{}{}{}{}", name, suffix, side.empty() ? "" : ".", side);
}

double one_normalised_peak(const MotionSpec& motion, int order, const Spelling& spelling) {
    if (spelling.unit.empty()) return 1.0;
    const double speed = is_unit_of_time(spelling.unit) ? *motion.speed : 1.0;
    return motion.lift * std::pow(speed / motion.unit_angle(), order) / spelling.factor;
}

Scene with_written_limits(Scene scene) {
    for (const PeakLimitRow& row : peak_limit_rows())
        if (auto& limit = row.in(scene.limits)) complete(row, *limit, scene.motion);
    const bool swings = scene.cam && scene.cam->formulas()->swings();
    for (const LimitRow& row : limit_rows())
        if (auto& limit = row.in(scene.limits)) complete(row, *limit, swings);
    return scene;
}

Scene valid_scene(Scene scene) {
    scene = with_written_limits(std::move(scene));
    validate(scene);
    return scene;
}

}  // namespace camopt
