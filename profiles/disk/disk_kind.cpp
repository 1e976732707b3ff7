// SPDX-License-Identifier: MIT
#include "profiles/disk/disk_kind.hpp"

#include "profiles/disk/disk_keys.hpp"
#include "profiles/disk/disk_spec.hpp"
#include "scene/follower.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

const char* touched_with(ContactKind contact) {
    if (contact == ContactKind::roller) return "a roller";
    return contact == ContactKind::flat ? "a flat face" : "a knife edge";
}

CamVariant variant(const Follower& follower) {
    CamVariant all;
    all.word = follower.name;
    all.spoken = fmt::format("the follower \"{}\"", follower.name);
    all.swings = follower.oscillates;
    all.touches_with = touched_with(follower.contact);
    all.spec = [type = follower.type] { return blank_disk_spec({.follower = type}); };
    int index = 0;
    for (int i = 0; i < dimension_count; ++i) {
        const auto which = static_cast<DimensionIndex>(i);
        CamNumber number{"cam", name_of(which), follower.has(which)};
        if (number.owned) number.index = index++;
        if (is_offset(which)) number.value = 0.0;
        all.numbers.push_back(std::move(number));
    }
    all.numbers.push_back({"cam", "face_half_width", follower.has_face_width});
    const bool roller = follower.contact == ContactKind::roller;
    for (const char* key : {"groove_clearance", "groove_wall", "second_roller_radius"})
        all.numbers.push_back({"cam", key, roller});
    for (const char* key : {"roller_distance", "second_offset"})
        all.numbers.push_back({"cam", key, roller && !follower.oscillates});
    for (const char* key : {"arm_angle", "second_arm_length"})
        all.numbers.push_back({"cam", key, roller && follower.oscillates});
    all.choices.push_back({"cam", "form"});
    return all;
}

/// The width of a face, the numbers of a form.
CamSpec with_given(const CamSpec& spec, const std::map<std::string, double>& given) {
    DiskSpec disk = disk_of(spec);
    const auto number = [&given](const char* key) {
        const auto found = given.find(key);
        return found == given.end() ? std::nullopt : std::optional(found->second);
    };
    disk.face_half_width = number("face_half_width");
    set_numbers(disk.form, number);
    return blank_disk_spec(disk);
}

}  // namespace

CamKind disk_kind() {
    CamKind kind;
    kind.type = disk_type;
    kind.spoken = "a disk cam with its follower";
    kind.choosing_table = "cam";
    kind.choosing_key = "follower";
    for (const Follower& follower : followers) kind.variants.push_back(variant(follower));
    kind.with_angle = "an oscillating follower";
    kind.with_length = "a translating follower";
    kind.is_direct = true;
    kind.rows = disk_rows();
    kind.also_called = disk_synonyms();
    kind.parts_called = follower_part_synonyms();
    kind.add_given = with_given;
    return kind;
}

}  // namespace camopt
