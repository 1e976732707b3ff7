// SPDX-License-Identifier: MIT
#include "input/mechanism_reader.hpp"

#include "profiles/kinds/cam_kinds.hpp"

#include <fmt/format.h>

namespace camopt::input {
namespace {

/// A scene's cam by what its kind says of itself.
class MechanismReader {
 public:
    MechanismReader(const SceneSource& source, const CamKind& kind)
        : source_(source), kind_(kind), variant_(chosen()) {}

    [[nodiscard]] MechanismSpec read(const MotionSpec& motion) const {
        check_lift(source_, kind_, variant_, motion);
        if (kind_.only_drd && motion.type != MotionType::drd)
            source_.fail_member("cam.type", fmt::format("found \"{}\" with the motion \"{}\"; allowed: the "
                                                        "motion \"DRD\"",
                                                        kind_.type, name_of(motion.type)));
        MechanismSpec spec = variant_.spec();
        if (kind_.has_rotation)
            source_.read_choice("cam", "rotation", {Rotation::counterclockwise, Rotation::clockwise},
                                spec.rotation);
        refuse_foreign();
        for (const CamNumber& number : variant_.numbers)
            if (number.owned)
                read_one(number, motion.lift, spec.dimensions[static_cast<std::size_t>(number.index)].value);
        for (const CamChoice& choice : variant_.choices)
            if (const auto given = source_.find(choice.table, choice.key))
                spec.choices[choice.key] = given->value().text;
        return spec;
    }

 private:
    const SceneSource& source_;
    const CamKind& kind_;
    const CamVariant& variant_;

    [[nodiscard]] const CamVariant& chosen() const {
        if (kind_.choosing_key.empty()) return kind_.variants.front();
        const auto given = source_.find(kind_.choosing_table, kind_.choosing_key);
        if (!given && kind_.choosing_table != "cam")
            source_.fail(source_.table("cam")->place, kind_.choosing_table,
                         fmt::format("missing; allowed: a [{}] table for a cam of type \"{}\"",
                                     kind_.choosing_table, kind_.type));
        const std::string word = given ? given->value().text : std::string();
        if (const CamVariant* const found = kind_.variant(word)) return *found;
        std::vector<std::string_view> allowed;
        for (const CamVariant& variant : kind_.variants) allowed.emplace_back(variant.word);
        source_.fail_member(fmt::format("{}.{}", kind_.choosing_table, kind_.choosing_key),
                            fmt::format("found \"{}\" for a cam of type \"{}\"; allowed: {}", word,
                                        kind_.type, quoted_choices(allowed)));
    }
    /// Keys of the other variants.
    void refuse_foreign() const {
        const auto refuse = [&](const auto& entry) {
            const auto given = source_.find(entry.table, entry.key);
            if (entry.owned || !given) return;
            source_.fail(
                given->member->place, joined_key(entry.table, given->member->name),
                fmt::format("found a key that {} does not have; allowed: leave it out", variant_.spoken));
        };
        for (const CamNumber& number : variant_.numbers) refuse(number);
        for (const CamChoice& choice : variant_.choices) refuse(choice);
    }
    void read_one(const CamNumber& number, double lift, Dimension& target) const {
        if (const auto given = source_.find(number.table, number.key)) {
            target = given->dimension();
            return;
        }
        const KeyRow* const row = find_row(number.table, number.key);
        if (!number.value && row)
            source_.fail(source_.table(number.table)->place,
                         joined_key(number.table, row->key(row->spellings.front())),
                         fmt::format("missing for {}; allowed: {}", variant_.spoken,
                                     row->allowed(row->spellings.front())));
        target = number.value.value_or(0.0) + number.per_lift * lift;
        if (!row) return;
        target.key = joined_key(number.table, row->key(row->spellings.front()));
        target.unit = row->spellings.front().factor;
    }
};

}  // namespace

void check_lift(const SceneSource& source, const CamKind& kind, const CamVariant& variant,
                const MotionSpec& motion) {
    if (variant.swings == motion.lift_is_angle) return;
    const std::string& allowed = motion.lift_is_angle ? kind.with_angle : kind.with_length;
    source.fail_member(
        kind.choosing_key.empty() ? "cam.type" : fmt::format("{}.{}", kind.choosing_table, kind.choosing_key),
        fmt::format("found \"{}\" where the lift is {}; allowed: {}{}{}{}", variant.word,
                    motion.lift_is_angle ? "an angle" : "a length", allowed, allowed.empty() ? "" : ", or ",
                    motion.lift_is_angle ? "motion.lift_mm, motion.lift_in or motion.lift_m"
                                         : "motion.lift_deg or motion.lift_rad",
                    kind.lift_remark));
}

std::optional<MechanismSpec> read_mechanism(const SceneSource& source, const MotionSpec& motion) {
    const auto type = source.find("cam", "type");
    const CamKind* const kind = type ? cam_kind(type->value().text) : nullptr;
    if (!kind || !kind->is_mechanism()) return std::nullopt;
    return MechanismReader(source, *kind).read(motion);
}

}  // namespace camopt::input
