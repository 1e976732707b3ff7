// SPDX-License-Identifier: MIT
#include "input/scene_parts.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

namespace camopt::input {
namespace {

[[noreturn]] void refuse_key(const SceneSource& source, const Given& given, std::string_view what) {
    source.fail(given.member->place, joined_key(given.row->table, given.member->name), what);
}

/// Forces are in N for a translating follower and in N m for a swinging one.
void check_force_unit(const SceneSource& source, std::string_view table, std::string_view quantity,
                      bool oscillating) {
    const auto given = source.find(table, quantity);
    if (!given) return;
    const std::string_view unit = given->spelling->unit;
    const bool fits_oscillating = is_turning_unit(unit);
    if (fits_oscillating == oscillating) return;
    std::string allowed;
    for (const KeyRow& row : scene_keys()) {
        if (row.table != table ||
            (row.name != quantity && row.instead_of != quantity && given->row->instead_of != row.name))
            continue;
        for (const Spelling& spelling : row.spellings)
            if (is_turning_unit(spelling.unit) == oscillating)
                allowed += (allowed.empty() ? "" : " or ") + row.key(spelling);
    }
    refuse_key(source, *given,
               fmt::format("found a value in {} where the follower {}; allowed: {}", unit,
                           oscillating ? "oscillates" : "translates", allowed));
}

/// `side`: "min" or "max" of a table; null: the number itself.
std::optional<WrittenLimit> read_limit(const SceneSource& source, std::string_view name,
                                       const char* side = nullptr) {
    const auto given = source.find("limits", name);
    if (!given || (side != nullptr) == given->value().is_number()) return std::nullopt;
    const Member* const bound = side != nullptr ? given->value().find(side) : given->member;
    if (bound == nullptr) return std::nullopt;
    std::string key = joined_key("limits", given->member->name);
    if (side != nullptr) key = joined_key(key, side);
    const double unit = given->spelling->factor;
    return WrittenLimit(bound->value.as_number() * unit, key, unit, std::string(given->spelling->unit));
}

}  // namespace

std::optional<CamSpec> read_cam(const SceneSource& source, const MotionSpec& motion,
                                const KnownNames& known) {
    const auto type = source.find("cam", "type");
    const CamKind* const kind = type ? cam_kind(type->value().text) : nullptr;
    if (!source.table("cam") || !kind) return std::nullopt;
    CamSpec cam = read_mechanism(source, *kind, motion);
    cam.make = kind->formulas ? kind->formulas : known.cam_formulas;
    if (!cam.make)
        source.fail_member("cam.type", fmt::format("found \"{}\", whose formulas this program does not have; "
                                                   "allowed: a cam whose formulas are linked",
                                                   kind->type));
    return cam;
}

std::optional<std::array<double, 2>> speed_range(const SceneSource& source, std::string_view table) {
    const auto range = source.find(table, "speed_range");
    if (!range) return std::nullopt;
    const auto& items = range->value().items;
    if (items.size() != 2)
        source.fail(range->value().place, joined_key(table, "speed_range"),
                    fmt::format("found {} numbers; allowed: two speeds, the lower first", items.size()));
    const double unit = range->spelling->factor;
    return std::array{items[0].as_number() * unit, items[1].as_number() * unit};
}

void read_forces(const SceneSource& source, Scene& scene) {
    if (!scene.forces) return;
    ForceSpec& forces = *scene.forces;
    if (scene.cam) {
        const bool swings = scene.cam->formulas()->swings();
        for (const char* quantity : {"mass", "inertia", "spring_rate", "preload", "damping", "load"})
            check_force_unit(source, "forces", quantity, swings);
    }
    if (const auto load = source.find("forces", "load")) {
        const double unit = load->spelling->factor;
        if (load->value().is_number()) forces.load = {{0.0, load->number()}};
        for (const Node& pair : load->value().items)
            forces.load.push_back(
                {pair.items[0].as_number() * units::degree, pair.items[1].as_number() * unit});
        if (!forces.load.empty() && forces.load.back()[0] - forces.load.front()[0] > units::turn)
            source.fail(load->value().place, joined_key("forces", load->member->name),
                        "found angles over more than 360 deg; allowed: those of one revolution");
    }
    forces.speed_range = speed_range(source, "forces");
}

void check_drive(const SceneSource& source, const MotionSpec& motion) {
    for (const char* quantity :
         {"load_mass", "load_inertia", "transmission", "viscous", "force", "moment", "friction"}) {
        const auto given = source.find("drive", quantity);
        if (!given) continue;
        const std::string_view unit = given->spelling->unit;
        const bool angle = is_turning_unit(unit) || is_angle_unit(unit);
        if (angle != motion.lift_is_angle)
            refuse_key(source, *given,
                       fmt::format("found a value in {} where the lift is {}; allowed: {}", unit,
                                   motion.lift_is_angle ? "an angle" : "a length",
                                   motion.lift_is_angle
                                       ? "load_inertia_kg_m2, transmission_deg_per_rev, viscous_nm_s_rad, "
                                         "moment_nm, friction_nm"
                                       : "load_mass_kg, transmission_mm_per_rev, viscous_n_s_m, force_n, "
                                         "friction_n"));
    }
    if (!source.find("drive", "transmission"))
        source.fail_member("drive", fmt::format("missing {}; allowed: a number > 0",
                                                motion.lift_is_angle ? "transmission_deg_per_rev"
                                                                     : "transmission_mm_per_rev"));
}

void read_cam_limits(const SceneSource& source, const Scene& scene, LimitSpec& limits) {
    if (scene.cam) {
        const bool swings = scene.cam->formulas()->swings();
        for (const LimitRow& row : limit_rows()) {
            if (row.swinging.name == nullptr) continue;
            for (const char* quantity : {row.name, row.swinging.name})
                check_force_unit(source, "limits", quantity, swings);
        }
    }
    for (const LimitRow& row : limit_rows()) {
        std::optional<WrittenLimit>& limit = row.in(limits);
        limit = read_limit(source, row.side != nullptr ? row.table : row.name, row.side);
        if (!limit && row.swinging.name != nullptr) limit = read_limit(source, row.swinging.name);
    }
    if (const auto curve = source.find("limits", "motor_curve"))
        for (const Node& pair : curve->value().items)
            limits.motor_curve.push_back(
                {pair.items[0].as_number() * units::revolution_per_minute, pair.items[1].as_number()});
    if (const auto harmonics = source.find("limits", "spring_harmonics")) {
        const Dimension range = harmonics->dimension();
        for (const double order : {range.low, range.high})
            if (order != std::round(order))
                source.fail(harmonics->value().place, "limits.spring_harmonics",
                            fmt::format("found {}; allowed: integers from 1 to {}", order, most_harmonic));
        limits.spring_harmonics = {static_cast<int>(range.low), static_cast<int>(range.high)};
    }
}

}  // namespace camopt::input
