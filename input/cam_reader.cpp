// SPDX-License-Identifier: MIT
#include "input/row_reader.hpp"
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

/// A cap on a peak: in a unit of the lift, in time with a speed.
void check_peak_limit(const SceneSource& source, const GivenAt& key, const MotionSpec& motion) {
    const std::string_view unit = key.unit();
    const Node& value = key.given.value();
    const std::string own =
        value.is_number() ? key.key : joined_key(key.key, value.find("min") != nullptr ? "min" : "max");
    const Place& place = key.given.member->place;
    if (unit.empty()) return;
    if (is_angle_unit(unit) != motion.lift_is_angle)
        source.fail(place, own,
                    fmt::format("found a limit in {} where the lift is {}; allowed: {}", unit,
                                motion.lift_is_angle ? "an angle" : "a length",
                                motion.lift_is_angle ? "a limit in deg or rad, or a normalised one"
                                                     : "a limit in mm, in or m, or a normalised one"));
    if (!motion.speed && is_unit_of_time(unit))
        source.fail(place, own,
                    fmt::format("found a limit in {} without a speed; allowed: together with "
                                "motion.speed_rpm or motion.speed_rad_s",
                                unit));
}

}  // namespace

void read_cam(const SceneSource& source, const KnownNames& known, Scene& scene) {
    if (!scene.cam) return;
    const auto type = source.find("cam", "type");
    const CamKind* const kind = type ? cam_kind(type->value().text) : nullptr;
    if (!kind) return scene.cam.reset();
    CamSpec cam = read_mechanism(source, *kind, scene.motion);
    cam.rotation = scene.cam->rotation;
    cam.make = kind->formulas ? kind->formulas : known.cam_formulas;
    if (!cam.make)
        source.fail_member("cam.type", fmt::format("found \"{}\", whose formulas this program does not have; "
                                                   "allowed: a cam whose formulas are linked",
                                                   kind->type));
    scene.cam = std::move(cam);
}

void check_speed_range(const SceneSource& source, std::string_view table) {
    const auto range = source.find(table, "speed_range");
    if (range && range->value().items.size() != 2)
        source.fail(range->value().place, joined_key(table, "speed_range"),
                    fmt::format("found {} numbers; allowed: two speeds, the lower first",
                                range->value().items.size()));
}

void check_forces(const SceneSource& source, const Scene& scene) {
    if (!scene.forces) return;
    if (scene.cam) {
        const bool swings = scene.cam->formulas()->swings();
        for (const char* quantity : {"mass", "inertia", "spring_rate", "preload", "damping", "load"})
            check_force_unit(source, "forces", quantity, swings);
    }
    const KeyPairs& pairs = scene.forces->load;
    if (!pairs.empty() && pairs.back()[0] - pairs.front()[0] > units::turn) {
        const Given load = source.find("forces", "load").value();
        source.fail(load.value().place, joined_key("forces", load.member->name),
                    "found angles over more than 360 deg; allowed: those of one revolution");
    }
    check_speed_range(source, "forces");
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

void read_limits(const SceneSource& source, Scene& scene) {
    if (scene.cam) {
        const bool swings = scene.cam->formulas()->swings();
        for (const LimitRow& row : limit_rows()) {
            if (row.swinging.name == nullptr) continue;
            for (const char* quantity : {row.name, row.swinging.name})
                check_force_unit(source, "limits", quantity, swings);
        }
    }
    if (const auto harmonics = source.find("limits", "spring_harmonics")) {
        const Dimension range = harmonics->dimension();
        for (const double order : {range.low, range.high})
            if (order != std::round(order))
                source.fail(harmonics->value().place, "limits.spring_harmonics",
                            fmt::format("found {}; allowed: integers from 1 to {}", order, most_harmonic));
    }
    const auto is_peak = [](std::string_view name) {
        return std::ranges::any_of(peak_limit_rows(),
                                   [&](const PeakLimitRow& row) { return row.term().name() == name; });
    };
    read_scaled_rows(source, "limits", scene, [&](const GivenAt& key) {
        if (is_peak(key.given.row->name)) check_peak_limit(source, key, scene.motion);
    });
}

}  // namespace camopt::input
