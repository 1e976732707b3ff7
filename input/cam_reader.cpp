// SPDX-License-Identifier: MIT
#include "input/row_reader.hpp"
#include "input/scene_parts.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "scene/limit_table.hpp"
#include "scene/unit_fault.hpp"

#include <fmt/format.h>

namespace camopt::input {
namespace {

/// The same of keys of one table, where they are given.
void check_units(const SceneSource& source, std::string_view table,
                 std::initializer_list<std::string_view> quantities, const MotionSpec& motion) {
    for (const std::string_view quantity : quantities)
        if (const auto given = source.find(table, quantity))
            check_unit(source, *given, joined_key(table, given->member->name), motion);
}

}  // namespace

void check_unit(const SceneSource& source, const Given& given, std::string_view key,
                const MotionSpec& motion) {
    const KeyRow& own = *given.row;
    std::vector<KeyNames> names;
    for (const KeyRow& row : source.rows)
        if (row.table == own.table &&
            (&row == &own || row.instead_of == own.name || own.instead_of == row.name))
            names.push_back(row.names());
    if (const auto fault = unit_fault(key, given.spelling->unit, motion, names))
        source.fail(given.member->place, key, words_of(*fault));
}

void read_cam(const SceneSource& source, const KnownNames& known, Scene& scene) {
    if (!scene.cam) return;
    const auto type = source.find("cam", "type");
    const CamKind* const kind = type ? cam_kind(type->value().text) : nullptr;
    if (!kind) return scene.cam.reset();
    CamSpec cam = read_mechanism(source, *kind, scene.motion);
    cam.rotation = scene.cam->rotation;
    cam.pieces = scene.cam->pieces;
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
    if (scene.cam)
        check_units(source, "forces", {"mass", "inertia", "spring_rate", "preload", "damping", "load"},
                    scene.motion);
    const KeyPairs& pairs = scene.forces->load;
    if (!pairs.empty() && pairs.back()[0] - pairs.front()[0] > units::turn) {
        const Given load = source.find("forces", "load").value();
        source.fail(load.value().place, joined_key("forces", load.member->name),
                    "found angles over more than 360 deg; allowed: those of one revolution");
    }
    check_speed_range(source, "forces");
}

void check_drive(const SceneSource& source, const MotionSpec& motion) {
    check_units(source, "drive",
                {"load_mass", "load_inertia", "transmission", "viscous", "force", "moment", "friction"},
                motion);
}

void read_limits(const SceneSource& source, Scene& scene) {
    if (scene.cam)
        for (const LimitRow& row : limit_rows())
            if (row.swinging.name != nullptr)
                check_units(source, "limits", {row.name, row.swinging.name}, scene.motion);
    if (const auto harmonics = source.find("limits", "spring_harmonics")) {
        const Dimension range = harmonics->dimension();
        for (const double order : {range.low, range.high})
            if (order != std::round(order))
                source.fail(harmonics->value().place, "limits.spring_harmonics",
                            fmt::format("found {}; allowed: integers from 1 to {}", order, most_harmonic));
    }
    const auto is_peak = [](std::string_view name) {
        return std::ranges::any_of(peak_limit_rows(),
                                   [&](const PeakLimitRow& row) { return row.key_name == name; });
    };
    read_scaled_rows(source, "limits", scene, [&](const GivenAt& key) {
        if (is_peak(key.given.row->name)) check_unit(source, key.given, key.key, scene.motion);
    });
}

}  // namespace camopt::input
