// SPDX-License-Identifier: MIT
#include "profiles/linear/linear_spec.hpp"

#include "core/errors.hpp"
#include "core/word_of.hpp"
#include "scene/cam_kind.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using enum KeyType;
using namespace spellings;

constexpr std::array plate_followers = {PlateFollower::translating_roller, PlateFollower::translating_knife,
                                        PlateFollower::oscillating_roller};
const Range inclination_range = {.low = -90.0, .high = 90.0, .low_included = false, .high_included = false};

// A row is read as a row.
// clang-format off
std::vector<KeyRow> linear_rows() {
    return {
        {"cam", "follower", text, plain, any, {}, "required",
         "With a linear cam `translating_roller`, `translating_knife` or `oscillating_roller`."},
        {"cam", "travel", number_or_range, length, any, {}, "required for linear",
         "How far the plate slides in one cycle of 360°; not 0. Positive: it slides towards −x (what touches the roller "
         "moves towards +x along the plate, towards the pivot of an arm), negative: the other way."},
        {"cam", "base_height", number, length, positive, {}, "required for linear",
         "From the plate's bottom to its surface at displacement 0."},
        {"cam", "inclination", number_or_range, angle, inclination_range, {}, "0",
         "Of the follower's path against the normal of the travel; positive leans towards +x and increases the "
         "pressure angle of a rise on a plate that slides towards −x. `translating_roller` and `translating_knife` only."},
        {"cam", "pivot_height", number_or_range, length, any, {}, "required for linear, oscillating",
         "Of the arm's pivot above the plate's bottom."},
    };
}
// clang-format on

CamVariant variant(PlateFollower follower) {
    CamVariant all;
    all.word = name_of(follower);
    all.spoken = fmt::format("the follower \"{}\"", all.word);
    all.swings = is_on_arm(follower);
    all.touches_with = follower == PlateFollower::translating_knife ? "a knife edge" : "a roller";
    all.spec = [follower] { return blank_linear_spec(follower); };
    for (int i = 0; i < plate_number_count; ++i) {
        const auto number = static_cast<PlateNumber>(i);
        CamNumber one{"cam", name_of(number), has_number(follower, number), {}, 0.0, i};
        if (number == PlateNumber::inclination) one.value = 0.0;
        all.numbers.push_back(std::move(one));
    }
    return all;
}

}  // namespace

const char* name_of(PlateFollower value) {
    return word_of<PlateFollower::oscillating_roller>(
        value, {"translating_roller", "translating_knife", "oscillating_roller"});
}

PlateFollower plate_follower(const CamSpec& spec) {
    if (spec.type != linear_type)
        throw InputError(fmt::format("a mechanism of type \"{}\"; allowed: \"linear\"", spec.type));
    return chosen(spec, "follower", plate_followers);
}

const char* name_of(PlateNumber value) {
    return word_of<PlateNumber::pivot_height>(
        value, {"travel", "base_height", "roller_radius", "inclination", "arm_length", "pivot_height"});
}

bool has_number(PlateFollower follower, PlateNumber number) {
    using enum PlateNumber;
    switch (number) {
        case travel:
        case base_height:
            return true;
        case roller_radius:
            return follower != PlateFollower::translating_knife;
        case inclination:
            return !is_on_arm(follower);
        case arm_length:
        case pivot_height:
            return is_on_arm(follower);
    }
    throw ModelError("linear cam: no known dimension");
}

CamSpec blank_linear_spec(PlateFollower follower) {
    CamSpec spec;
    spec.type = linear_type;
    spec.choices["follower"] = name_of(follower);
    for (int i = 0; i < plate_number_count; ++i) {
        const auto number = static_cast<PlateNumber>(i);
        Dimension value;
        const bool is_angle = number == PlateNumber::inclination;
        if (is_angle) value.unit = units::degree;
        spec.dimensions.push_back({name_of(number), value, is_angle});
    }
    return spec;
}

CamKind linear_kind() {
    CamKind kind;
    kind.type = linear_type;
    kind.spoken = "a plate that slides under its follower";
    kind.choosing_table = "cam";
    kind.choosing_key = "follower";
    for (const PlateFollower follower : plate_followers) kind.variants.push_back(variant(follower));
    kind.with_angle = "\"oscillating_roller\"";
    kind.with_length = "\"translating_roller\" or \"translating_knife\"";
    kind.has_rotation = false;
    kind.outputs = {CamOutput::outline, CamOutput::sheet, CamOutput::solid, CamOutput::program};
    kind.rows = linear_rows();
    kind.refused = {
        {"translating_flat",
         "a flat face that is pushed straight keeps its direction on a plate that slides, so that no "
         "profile gives it a motion (docs/linear_cams.md)"}};
    return kind;
}

}  // namespace camopt
