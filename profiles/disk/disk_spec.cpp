// SPDX-License-Identifier: MIT
#include "profiles/disk/disk_spec.hpp"

#include "scene/key_row.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

using Fault = std::optional<SceneFault>;

Fault foreign_dimension_fault(const DiskSpec& cam) {
    const auto fault = [&](const std::string& member, const std::string& having) {
        return SceneFault{
            member, fmt::format("a dimension that the follower \"{}\" does not have", name_of(cam.follower)),
            "only with " + having};
    };
    for (int i = 0; i < dimension_count; ++i) {
        const auto index = static_cast<DimensionIndex>(i);
        if (has_dimension(cam.follower, index) || (cam[index].low == 0.0 && cam[index].high == 0.0)) continue;
        return fault(fmt::format("cam.{}", name_of(index)), followers_with(index));
    }
    if (cam.face_half_width && !follower_of(cam.follower).has_face_width)
        return fault("cam.face_half_width", followers_with_face_width());
    return std::nullopt;
}

/// A given number belongs to another form or follower.
Fault foreign_number_fault(const DiskSpec& cam) {
    const FormSpec& form = cam.form;
    const bool swings = is_oscillating(cam.follower);
    struct Row {
        bool given, fits;
        const char *member, *allowed;
    };
    const bool slides_conjugate = form.is_conjugate() && !swings,
               swings_conjugate = form.is_conjugate() && swings;
    constexpr const char* groove = "only with cam.form = \"grooved\"";
    constexpr const char* conjugate = "only with cam.form = \"conjugate\"";
    constexpr const char* sliding = "only with cam.form = \"conjugate\" and a translating roller";
    constexpr const char* swinging = "only with cam.form = \"conjugate\" and an oscillating roller";
    const std::array<Row, 7> rows = {{
        {form.groove_clearance != 0.0, form.is_grooved(), "cam.groove_clearance", groove},
        {form.groove_wall.has_value(), form.is_grooved(), "cam.groove_wall", groove},
        {form.second_roller_radius.has_value(), form.is_conjugate(), "cam.second_roller_radius", conjugate},
        {form.roller_distance != 0.0, slides_conjugate, "cam.roller_distance", sliding},
        {form.second_offset.has_value(), slides_conjugate, "cam.second_offset", sliding},
        {form.arm_angle != 0.0, swings_conjugate, "cam.arm_angle", swinging},
        {form.second_arm_length.has_value(), swings_conjugate, "cam.second_arm_length", swinging},
    }};
    for (const Row& row : rows)
        if (row.given && !row.fits)
            return SceneFault{
                row.member,
                fmt::format("a number that a cam of form \"{}\" with the follower \"{}\" does not have",
                            name_of(form.type), name_of(cam.follower)),
                row.allowed};
    return std::nullopt;
}

/// In a unit of a scene file: as written, else mm.
void complete_key(Dimension& dimension, const char* name) {
    if (!dimension.key.empty()) return;
    const Spelling* spelling = &spellings::length.front();
    for (const Spelling& one : spellings::length)
        if (one.factor == dimension.unit) spelling = &one;
    dimension.key = fmt::format("cam.{}{}", name, spelling->suffix);
    dimension.unit = spelling->factor;
}

}  // namespace

std::optional<SceneFault> foreign_fault(const DiskSpec& cam) {
    if (Fault fault = foreign_dimension_fault(cam)) return fault;
    if (cam.form.drives_both_ways() && !has_roller(cam.follower))
        return SceneFault{
            "cam.form",
            fmt::format("\"{}\" for the follower \"{}\"", name_of(cam.form.type), name_of(cam.follower)),
            "only with translating_roller and oscillating_roller: the others touch one side"};
    return foreign_number_fault(cam);
}

const char* name_of(CamForm value) {
    if (value == CamForm::open) return "open";
    return value == CamForm::grooved ? "grooved" : "conjugate";
}

std::vector<DimensionIndex> dimensions_of(FollowerType follower) {
    std::vector<DimensionIndex> all;
    for (int d = 0; d < dimension_count; ++d)
        if (has_dimension(follower, static_cast<DimensionIndex>(d)))
            all.push_back(static_cast<DimensionIndex>(d));
    return all;
}

std::vector<CamDimension> form_dimensions(FollowerType follower, const FormSpec& form) {
    std::vector<CamDimension> all;
    const auto add = [&](const char* name, double value, bool is_angle) {
        CamDimension dimension{name, Dimension(value), is_angle};
        dimension.value.key = fmt::format("cam.{}_{}", name, is_angle ? "deg" : "mm");
        dimension.value.unit = is_angle ? units::degree : units::millimetre;
        all.push_back(std::move(dimension));
    };
    const auto add_given = [&](const char* name, const std::optional<double>& value) {
        if (value) add(name, *value, false);
    };
    if (form.is_grooved()) {
        add("groove_clearance", form.groove_clearance, false);
        add_given("groove_wall", form.groove_wall);
    }
    if (!form.is_conjugate()) return all;
    if (is_oscillating(follower)) {
        add("arm_angle", form.arm_angle, true);
        add_given("second_arm_length", form.second_arm_length);
    } else {
        add("roller_distance", form.roller_distance, false);
        add_given("second_offset", form.second_offset);
    }
    add_given("second_roller_radius", form.second_roller_radius);
    return all;
}

void set_numbers(FormSpec& form, const FormNumbers& given) {
    form.groove_clearance = given("groove_clearance").value_or(0.0);
    form.groove_wall = given("groove_wall");
    form.roller_distance = given("roller_distance").value_or(0.0);
    form.arm_angle = given("arm_angle").value_or(0.0);
    form.second_roller_radius = given("second_roller_radius");
    form.second_offset = given("second_offset");
    form.second_arm_length = given("second_arm_length");
}

CamSpec blank_disk_spec(const DiskSpec& cam) {
    if (const Fault fault = foreign_fault(cam)) throw SceneError(*fault);
    CamSpec spec;
    spec.type = disk_type;
    spec.rotation = cam.rotation;
    spec.choices["follower"] = name_of(cam.follower);
    spec.choices["form"] = name_of(cam.form.type);
    spec.face_half_width = cam.face_half_width;
    for (const DimensionIndex which : dimensions_of(cam.follower)) {
        CamDimension dimension{name_of(which), cam[which], false};
        complete_key(dimension.value, name_of(which));
        spec.dimensions.push_back(std::move(dimension));
    }
    for (CamDimension& dimension : form_dimensions(cam.follower, cam.form))
        spec.dimensions.push_back(std::move(dimension));
    return spec;
}

DiskSpec disk_of(const CamSpec& cam) {
    if (cam.type != disk_type)
        throw InputError(fmt::format("a cam of type \"{}\"; allowed: \"disk\"", cam.type));
    DiskSpec disk;
    std::array<FollowerType, followers.size()> types{};
    std::ranges::transform(followers, types.begin(), &Follower::type);
    disk.follower = chosen(cam, "follower", types);
    disk.rotation = cam.rotation;
    disk.face_half_width = cam.face_half_width;
    disk.form.type = chosen(cam, "form", std::array{CamForm::open, CamForm::grooved, CamForm::conjugate});
    for (int i = 0; i < dimension_count; ++i)
        if (const Dimension* const found = cam.find(static_cast<DimensionIndex>(i)))
            disk.dimensions[i] = *found;
    const auto given = [&](const char* name) {
        const Dimension* const found = cam.find(name);
        return found ? std::optional(found->low) : std::nullopt;
    };
    set_numbers(disk.form, given);
    return disk;
}

}  // namespace camopt
