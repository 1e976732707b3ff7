// SPDX-License-Identifier: MIT
#include "input/spatial_reader.hpp"

#include "core/units.hpp"
#include "scene/spatial_spec.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace camopt::input {
namespace {

using enum SpatialFollower;

/// What a scene need not say.
std::optional<double> default_of(SpatialFollower follower, SpatialNumber number, double lift) {
    if (number == SpatialNumber::axial_offset) return 0.0;
    if (number == SpatialNumber::lateral_offset && follower != barrel) return 0.0;
    if (number == SpatialNumber::start) return follower == cylindrical_translating ? 0.0 : -0.5 * lift;
    if (number == SpatialNumber::arm_length && follower == cylindrical_translating) return 0.0;
    return std::nullopt;
}

class SpatialReader {
 public:
    explicit SpatialReader(const SceneSource& source) : source_(source), follower_(read_follower()) {}

    [[nodiscard]] MechanismSpec read(const MotionSpec& motion) const {
        if (swings(follower_) != motion.lift_is_angle)
            source_.fail_member(
                follower_ == barrel ? "cam.type" : "cam.follower",
                fmt::format("found \"{}\" where the lift is {}",
                            follower_ == barrel ? "barrel" : follower_word(),
                            motion.lift_is_angle
                                ? "an angle; allowed: \"rotating\", or motion.lift_mm, motion.lift_in or "
                                  "motion.lift_m"
                                : "a length; allowed: a cylindrical cam with a \"translating\" follower, or "
                                  "motion.lift_deg or motion.lift_rad"));
        MechanismSpec spec = spatial_spec(follower_);
        source_.read_choice("cam", "rotation", {Rotation::counterclockwise, Rotation::clockwise},
                            spec.rotation);
        refuse_foreign();
        for (int i = 0; i < spatial_number_count; ++i)
            read_one(static_cast<SpatialNumber>(i), motion.lift,
                     spec.dimensions[static_cast<std::size_t>(i)].value);
        return spec;
    }

 private:
    const SceneSource& source_;
    SpatialFollower follower_;

    [[nodiscard]] std::string follower_word() const {
        const auto given = source_.find("cam", "follower");
        return given ? given->value().text : std::string();
    }
    [[nodiscard]] SpatialFollower read_follower() const {
        const auto type = source_.find("cam", "type");
        if (type->value().text == "barrel") return barrel;
        const std::string word = follower_word();
        if (word == "rotating") return cylindrical_rotating;
        if (word == "translating") return cylindrical_translating;
        source_.fail_member(
            "cam.follower",
            fmt::format("found \"{}\" for a cam of type \"cylindrical\"; allowed: \"rotating\" "
                        "or \"translating\"",
                        word));
    }
    /// Keys of the other followers.
    void refuse_foreign() const {
        for (const char* name : {"cylinder_radius", "center_distance", "arm_length", "start_angle"}) {
            const auto given = source_.find("cam", name);
            bool owned = false;
            for (int i = 0; i < spatial_number_count; ++i)
                owned = owned || spatial_key(follower_, static_cast<SpatialNumber>(i)) == name;
            if (given && !owned)
                source_.fail(
                    given->member->place, joined_key("cam", given->member->name),
                    fmt::format("found a key that this cam (\"{}\") does not have; allowed: leave it out",
                                name_of(follower_)));
        }
    }
    void read_one(SpatialNumber number, double lift, Dimension& target) const {
        const std::string name = spatial_key(follower_, number);
        if (!name.empty())
            if (const auto given = source_.find("cam", name)) {
                target = given->dimension();
                return;
            }
        const KeyRow* row = nullptr;
        for (const KeyRow& candidate : scene_keys())
            if (candidate.table == "cam" && candidate.name == name) row = &candidate;
        const std::optional<double> value = default_of(follower_, number, lift);
        if (!value && row)
            source_.fail(source_.table("cam")->place, joined_key("cam", row->key(row->spellings.front())),
                         fmt::format("missing for this cam (\"{}\"); allowed: {}", name_of(follower_),
                                     row->allowed(row->spellings.front())));
        target = value.value_or(0.0);
        if (row) {
            target.key = joined_key("cam", row->key(row->spellings.front()));
            target.unit = row->spellings.front().factor;
        }
    }
};

}  // namespace

std::string spatial_key(SpatialFollower follower, SpatialNumber number) {
    const bool slides = follower == cylindrical_translating;
    if (number == SpatialNumber::center_distance && slides) return "cylinder_radius";
    if (number == SpatialNumber::arm_length && slides) return {};
    if (number == SpatialNumber::start) return slides ? "" : "start_angle";
    return name_of_number(number);
}

MechanismSpec read_spatial(const SceneSource& source, const MotionSpec& motion) {
    return SpatialReader(source).read(motion);
}

}  // namespace camopt::input
