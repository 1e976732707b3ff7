// SPDX-License-Identifier: MIT
#include "profiles/spatial/spatial_spec.hpp"

#include "core/errors.hpp"
#include "core/word_of.hpp"
#include "scene/cam_kind.hpp"

#include <fmt/format.h>

namespace camopt {

using enum SpatialFollower;

const char* name_of(SpatialFollower value) {
    return word_of<cylindrical_translating>(value,
                                            {"barrel", "cylindrical_rotating", "cylindrical_translating"});
}

const char* name_of_number(SpatialNumber value) {
    static constexpr std::array<const char*, spatial_number_count> names = {
        "roller_radius", "arm_length", "center_distance", "lateral_offset", "axial_offset",
        "roller_length", "start"};
    return names[static_cast<std::size_t>(value)];
}

namespace {

constexpr std::array<const char*, 4> form_keys = {"groove_clearance", "groove_wall", "body_diameter",
                                                  "body_length"};

/// Those that a scene gives, behind its numbers.
CamSpec with_form(CamSpec spec, const std::map<std::string, double>& given) {
    for (const char* const key : form_keys)
        if (const auto found = given.find(key); found != given.end()) {
            CamDimension dimension{key, Dimension(found->second), false};
            dimension.value.key = fmt::format("cam.{}_mm", key);
            spec.dimensions.push_back(std::move(dimension));
        }
    return spec;
}

}  // namespace

DrumForm drum_form(const CamSpec& spec) {
    const auto given = [&](const char* key) {
        const Dimension* const found = spec.find(key);
        return found == nullptr ? std::nullopt : std::optional(found->low);
    };
    return {given("groove_clearance").value_or(0.0),
            {given("body_diameter"), given("body_length"), given("groove_wall")}};
}

CamSpec blank_spatial_spec(SpatialFollower follower) {
    CamSpec spec;
    spec.type = follower == barrel ? barrel_type : cylindrical_type;
    if (follower != barrel)
        spec.choices["follower"] = follower == cylindrical_rotating ? "rotating" : "translating";
    for (int i = 0; i < spatial_number_count; ++i) {
        const auto number = static_cast<SpatialNumber>(i);
        spec.dimensions.push_back(
            {name_of_number(number), {}, number == SpatialNumber::start && swings(follower)});
    }
    return spec;
}

SpatialFollower spatial_follower(const CamSpec& spec) {
    if (spec.type == barrel_type) return barrel;
    const auto choice = spec.choices.find("follower");
    if (spec.type == cylindrical_type && choice != spec.choices.end()) {
        if (choice->second == "rotating") return cylindrical_rotating;
        if (choice->second == "translating") return cylindrical_translating;
    }
    throw InputError(
        "a mechanism of type \"" + spec.type +
        "\"; allowed: \"barrel\", or \"cylindrical\" with a follower \"rotating\" or \"translating\"");
}

namespace {

using enum KeyType;
using namespace spellings;

// A row is read as a row.
// clang-format off
std::vector<KeyRow> spatial_rows() {
    return {
        {"cam", "follower", text, plain, any, {}, "required",
         "With a cylindrical cam `rotating`, whose lift is an angle, or `translating`, whose lift is a length."},
        {"cam", "center_distance", number_or_range, length, positive, {}, "required for rotating, barrel",
         "Cylindrical: to the pivot of a rotating follower. Barrel: from the cam's axis to the rollers' near end."},
        {"cam", "arm_length", number_or_range, length, positive, {}, "required for rotating, barrel",
         "To the roller's near end: `rotating`; barrel: the index radius, from the index's axis to the rollers'."},
        {"cam", "cylinder_radius", number_or_range, length, positive, {}, "required for cylindrical, translating",
         "From the cam's axis to the roller's near end; the roller's axis points to the cam's. "
         "`cylindrical` with a `translating` follower only."},
        {"cam", "roller_length", number_or_range, length, positive, {}, "required for barrel, cylindrical",
         "Length of the roller; every limit holds from its near to its far end."},
        {"cam", "lateral_offset", number_or_range, length, any, {}, "0",
         "From the cam's axis across it: to the pivot of a rotating or the axis of a translating follower (+x); "
         "of a barrel cam's index axis (−x)."},
        {"cam", "axial_offset", number, length, any, {}, "0",
         "Of the follower along the cam's axis; shifts the cam and changes no limit."},
        {"cam", "start_angle", number, angle, any, {}, "minus half the lift",
         "Angle of the index arm or the rotating follower from the line through both axes at displacement 0."},
        {"cam", "groove_clearance", number, length, not_negative, {}, "0",
         "Drums: width of the groove less the roller's diameter, half of it on either side."},
        {"cam", "groove_wall", number, length, positive, {}, "the roller radius",
         "Drums: least wall between the groove and either end of the body; not where rollers leave by its ends."},
        {"cam", "body_diameter", number, length, positive, {}, "up to the roller's near end",
         "Of the drum's cylindrical outside: between the far and the near end of the roller."},
        {"cam", "body_length", number, length, positive, {}, "the groove and both walls",
         "Of the drum along its axis; the groove lies in its middle."},
    };
}
// clang-format on

/// The key in [cam] that says a number; empty: none does.
std::string key_of(SpatialFollower follower, SpatialNumber number) {
    const bool slides = follower == cylindrical_translating;
    if (number == SpatialNumber::center_distance && slides) return "cylinder_radius";
    if (number == SpatialNumber::arm_length && slides) return {};
    if (number == SpatialNumber::start) return slides ? "" : "start_angle";
    return name_of_number(number);
}

/// What a scene need not say.
CamNumber number_of(SpatialFollower follower, int index) {
    const auto number = static_cast<SpatialNumber>(index);
    CamNumber one{"cam", key_of(follower, number), true, {}, 0.0, index};
    const bool is_offset = number == SpatialNumber::lateral_offset || number == SpatialNumber::axial_offset;
    if (is_offset || number == SpatialNumber::start || one.key.empty()) one.value = 0.0;
    if (number == SpatialNumber::start && swings(follower)) one.per_lift = -0.5;
    return one;
}

CamVariant variant(SpatialFollower follower) {
    CamVariant all{follower == barrel                 ? barrel_type
                   : follower == cylindrical_rotating ? "rotating"
                                                      : "translating",
                   fmt::format("this cam (\"{}\")", name_of(follower)),
                   swings(follower),
                   follower == barrel ? "the rollers of an index" : "a roller in a groove",
                   {},
                   {},
                   [follower] { return blank_spatial_spec(follower); }};
    for (int i = 0; i < spatial_number_count; ++i) all.numbers.push_back(number_of(follower, i));
    for (const char* const key : form_keys) all.numbers.push_back({"cam", key});
    // Keys of the other followers.
    for (const char* key : {"cylinder_radius", "center_distance", "arm_length", "start_angle"})
        if (std::ranges::find(all.numbers, key, &CamNumber::key) == all.numbers.end())
            all.numbers.push_back({"cam", key, false});
    return all;
}

CamKind kind_of(const char* type, std::vector<CamVariant> variants) {
    CamKind kind;
    kind.type = type;
    kind.variants = std::move(variants);
    kind.with_angle = "\"rotating\"";
    kind.with_length = "a cylindrical cam with a \"translating\" follower";
    kind.outputs = {CamOutput::sheet, CamOutput::solid, CamOutput::program};
    kind.add_given = with_form;
    return kind;
}

}  // namespace

CamKind barrel_kind() {
    CamKind kind = kind_of(barrel_type, {variant(barrel)});
    kind.spoken = "a barrel cam with its index";
    kind.rows = spatial_rows();
    return kind;
}

CamKind cylindrical_kind() {
    CamKind kind =
        kind_of(cylindrical_type, {variant(cylindrical_rotating), variant(cylindrical_translating)});
    kind.spoken = "a cylindrical cam";
    kind.choosing_table = "cam";
    kind.choosing_key = "follower";
    return kind;
}

}  // namespace camopt
