// SPDX-License-Identifier: MIT
#include "input/mechanism_reader.hpp"

#include "core/units.hpp"
#include "input/inverse_reader.hpp"
#include "input/spatial_reader.hpp"
#include "scene/remote_spec.hpp"

#include <fmt/format.h>

namespace camopt::input {
namespace {

using enum RemoteDimension;

/// What a scene need not say.
std::optional<double> default_of(RemoteDimension which) {
    switch (which) {
        case center_x:
        case center_y:
        case lever_angle:
        case rocker_angle:
            return 0.0;
        case slider_angle:
            return 90.0 * units::degree;
        default:
            return std::nullopt;
    }
}

const KeyRow& row_of(RemoteDimension which) {
    for (const KeyRow& row : scene_keys())
        if (row.table == table_of(which) && row.name == name_of(which)) return row;
    return scene_keys().front();
}

class RemoteReader {
 public:
    explicit RemoteReader(const SceneSource& source) : source_(source) {
        const auto given = source_.find("linkage", "type");
        if (!given)
            source_.fail(source_.table("cam")->place, "linkage",
                         "missing; allowed: a [linkage] table for a cam of type \"remote\"");
        source_.read_choice(
            "linkage", "type",
            {RemoteLinkage::lever, RemoteLinkage::lever_coupler_slider, RemoteLinkage::lever_coupler_lever,
             RemoteLinkage::lever_coupler_lever_coupler_slider},
            linkage_);
    }

    [[nodiscard]] MechanismSpec read(const MotionSpec& motion) const {
        if (output_swings(linkage_) != motion.lift_is_angle)
            source_.fail_member(
                "linkage.type",
                fmt::format("found \"{}\" where the lift is {}", name_of(linkage_),
                            motion.lift_is_angle
                                ? "an angle; allowed: \"lever\" or \"lever_coupler_lever\", or "
                                  "motion.lift_mm, motion.lift_in or motion.lift_m"
                                : "a length; allowed: a linkage with a slider, or "
                                  "motion.lift_deg or motion.lift_rad"));
        MechanismSpec spec = remote_spec(linkage_);
        source_.read_choice("cam", "rotation", {Rotation::counterclockwise, Rotation::clockwise},
                            spec.rotation);
        for (int i = 0; i < remote_dimension_count; ++i)
            read_one(static_cast<RemoteDimension>(i), spec.dimensions[static_cast<std::size_t>(i)].value);
        read_text("cam", "pressure_angle_at", spec);
        read_branch("lever_branch", has_dimension(linkage_, lever_arm), spec);
        read_branch("rocker_branch", has_dimension(linkage_, second_coupler), spec);
        return spec;
    }

 private:
    const SceneSource& source_;
    RemoteLinkage linkage_ = RemoteLinkage::lever;

    void read_one(RemoteDimension which, Dimension& target) const {
        const char* const table = table_of(which);
        const auto given = source_.find(table, name_of(which));
        if (!has_dimension(linkage_, which)) {
            if (given) refuse(*given);
            return;
        }
        if (given) {
            target = given->dimension();
            return;
        }
        const std::optional<double> value = default_of(which);
        const KeyRow& row = row_of(which);
        const Spelling& spelling = row.spellings.front();
        const std::string key = joined_key(table, row.key(spelling));
        if (!value)
            source_.fail(source_.table(table)->place, key,
                         fmt::format("missing for the linkage \"{}\"; allowed: {}", name_of(linkage_),
                                     row.allowed(spelling)));
        target = *value;
        target.key = key;
        target.unit = spelling.factor;
    }
    void read_text(const char* table, const char* name, MechanismSpec& spec) const {
        if (const auto given = source_.find(table, name)) spec.choices[name] = given->value().text;
    }
    void read_branch(const char* name, bool owned, MechanismSpec& spec) const {
        const auto given = source_.find("linkage", name);
        if (given && !owned) refuse(*given);
        read_text("linkage", name, spec);
    }
    [[noreturn]] void refuse(const Given& given) const {
        source_.fail(given.member->place, joined_key(given.row->table, given.member->name),
                     fmt::format("found a key that the linkage \"{}\" does not have; allowed: leave it out",
                                 name_of(linkage_)));
    }
};

}  // namespace

std::optional<MechanismSpec> read_mechanism(const SceneSource& source, const MotionSpec& motion) {
    const auto type = source.find("cam", "type");
    if (!type || type->value().text == "disk") return std::nullopt;
    if (type->value().text == "remote") return RemoteReader(source).read(motion);
    if (type->value().text == "inverse") return read_inverse(source, motion);
    return read_spatial(source, motion);
}

}  // namespace camopt::input
