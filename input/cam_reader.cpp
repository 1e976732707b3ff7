// SPDX-License-Identifier: MIT
#include "input/cam_reader.hpp"

#include "input/mechanism_reader.hpp"
#include "profiles/disk/disk_spec.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "scene/cam_mechanism.hpp"
#include "scene/limit_table.hpp"
#include "scene/scene_error.hpp"

#include <fmt/format.h>

namespace camopt::input {
namespace {

[[noreturn]] void refuse_key(const SceneSource& source, const Given& given, std::string_view what) {
    source.fail(given.member->place, joined_key(given.row->table, given.member->name), what);
}

[[noreturn]] void refuse_dimension(const SceneSource& source, const Given& given, const DiskSpec& cam,
                                   std::string_view having) {
    refuse_key(source, given,
               fmt::format("found a dimension that the follower \"{}\" does not have; allowed: only with {}",
                           name_of(cam.follower), having));
}

[[noreturn]] void refuse_missing(const SceneSource& source, const DiskSpec& cam, DimensionIndex index) {
    if (const KeyRow* const row = find_row("cam", name_of(index)))
        source.fail(source.table("cam")->place, joined_key("cam", row->key(row->spellings.front())),
                    fmt::format("missing for the follower \"{}\"; allowed: {}", name_of(cam.follower),
                                row->allowed(row->spellings.front())));
    source.fail(source.table("cam")->place, joined_key("cam", name_of(index)), "missing");
}

void read_form(const SceneSource& source, FormSpec& form) {
    source.read_choice("cam", "form", {CamForm::open, CamForm::grooved, CamForm::conjugate}, form.type);
    source.read_number("cam", "groove_clearance", form.groove_clearance);
    form.groove_wall = source.number("cam", "groove_wall");
    source.read_number("cam", "roller_distance", form.roller_distance);
    source.read_number("cam", "arm_angle", form.arm_angle);
    form.second_roller_radius = source.number("cam", "second_roller_radius");
    form.second_offset = source.number("cam", "second_offset");
    form.second_arm_length = source.number("cam", "second_arm_length");
}

/// Forces have units of N where the follower translates and of N m where it swings.
void check_force_unit(const SceneSource& source, std::string_view table, std::string_view quantity,
                      bool oscillating) {
    const auto given = source.find(table, quantity);
    if (!given) return;
    const std::string_view unit = given->spelling->unit;
    const bool fits_oscillating = unit.starts_with("N m") || unit == "kg m^2";
    if (fits_oscillating == oscillating) return;
    std::string allowed;
    for (const KeyRow& row : scene_keys()) {
        if (row.table != table ||
            (row.name != quantity && row.instead_of != quantity && given->row->instead_of != row.name))
            continue;
        for (const Spelling& spelling : row.spellings)
            if ((spelling.unit.starts_with("N m") || spelling.unit == "kg m^2") == oscillating)
                allowed += (allowed.empty() ? "" : " or ") + row.key(spelling);
    }
    refuse_key(source, *given,
               fmt::format("found a value in {} where the follower {}; allowed: {}", unit,
                           oscillating ? "oscillates" : "translates", allowed));
}

/// A follower of other kinds.
std::string foreign_follower(const CamKind& own, const std::string& word) {
    std::vector<std::string_view> types;
    for (const CamKind& kind : cam_kinds())
        if (kind.variant(word)) types.emplace_back(kind.type);
    return fmt::format("found \"{}\" for a cam of type \"{}\"; allowed: only with cam.type = {}", word,
                       own.type, quoted_choices(types));
}

std::optional<WrittenLimit> read_limit(const SceneSource& source, std::string_view name) {
    const auto given = source.find("limits", name);
    if (!given) return std::nullopt;
    return WrittenLimit(given->number(), joined_key("limits", given->member->name), given->spelling->factor,
                        std::string(given->spelling->unit));
}

CamSpec read_disk(const SceneSource& source, const CamKind& kind, const MotionSpec& motion) {
    DiskSpec cam;
    if (const auto given = source.find("cam", "follower"))
        if (const std::string& word = given->value().text; !kind.variant(word))
            refuse_key(source, *given, foreign_follower(kind, word));
    if (const auto given = source.find("cam", "follower"))
        for (const Follower& row : followers)
            if (given->value().text == row.name) cam.follower = row.type;
    source.read_choice("cam", "rotation", {Rotation::counterclockwise, Rotation::clockwise}, cam.rotation);
    check_lift(source, kind, *kind.variant(name_of(cam.follower)), motion);
    for (int i = 0; i < dimension_count; ++i) {
        const auto index = static_cast<DimensionIndex>(i);
        const bool owned = has_dimension(cam.follower, index);
        const auto given = source.find("cam", name_of(index));
        if (given && !owned) refuse_dimension(source, *given, cam, followers_with(index));
        if (!given && owned && !is_offset(index)) refuse_missing(source, cam, index);
        if (given) cam[index] = given->dimension();
    }
    if (const auto width = source.find("cam", "face_half_width")) {
        if (!follower_of(cam.follower).has_face_width)
            refuse_dimension(source, *width, cam, followers_with_face_width());
        cam.face_half_width = width->number();
    }
    read_form(source, cam.form);
    try {
        return blank_disk_spec(cam);
    } catch (const SceneError& error) {
        source.fail_member(error.fault().member, words_of(error.fault()));
    }
}

}  // namespace

std::optional<CamSpec> read_cam(const SceneSource& source, const MotionSpec& motion,
                                const KnownNames& known) {
    const auto type = source.find("cam", "type");
    const CamKind* const kind = type ? cam_kind(type->value().text) : nullptr;
    if (!source.table("cam") || !kind) return std::nullopt;
    CamSpec cam = kind->is_mechanism() ? read_mechanism(source, *kind, motion) : read_disk(source, *kind, motion);
    cam.make = kind->formulas ? kind->formulas : known.cam_formulas;
    if (!cam.make)
        source.fail_member("cam.type", fmt::format("found \"{}\", whose formulas this program does not have; "
                                                   "allowed: a cam that it brings the formulas of",
                                                   kind->type));
    return cam;
}

std::optional<ForceSpec> read_forces(const SceneSource& source, const Scene& scene) {
    const Node* table = source.table("forces");
    if (!table) return std::nullopt;
    ForceSpec forces;
    if (scene.cam) {
        const bool swings = scene.cam->formulas()->swings();
        for (const char* quantity : {"mass", "inertia", "spring_rate", "preload"})
            check_force_unit(source, "forces", quantity, swings);
    }
    source.read_number("forces", "mass", forces.mass);
    source.read_number("forces", "inertia", forces.mass);
    source.read_number("forces", "spring_rate", forces.spring_rate);
    source.read_number("forces", "preload", forces.preload);
    forces.contact_width = source.number("forces", "contact_width");
    source.read_number("forces", "cam_modulus", forces.cam_modulus);
    source.read_number("forces", "follower_modulus", forces.follower_modulus);
    source.read_number("forces", "cam_poisson", forces.cam_poisson);
    source.read_number("forces", "follower_poisson", forces.follower_poisson);
    return forces;
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
        limit = read_limit(source, row.name);
        if (!limit && row.swinging.name != nullptr) limit = read_limit(source, row.swinging.name);
    }
}

}  // namespace camopt::input
