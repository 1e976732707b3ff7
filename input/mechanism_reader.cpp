// SPDX-License-Identifier: MIT
#include "core/text/quantity_text.hpp"
#include "input/row_reader.hpp"
#include "input/scene_parts.hpp"
#include "profiles/kinds/cam_kinds.hpp"
#include "scene/unit_fault.hpp"

#include <fmt/format.h>

namespace camopt::input {

namespace {

/// A scene's cam by the description of its kind.
class MechanismReader {
 public:
    MechanismReader(const SceneSource& source, const CamKind& kind)
        : source_(source), kind_(kind), variant_(chosen()) {}

    [[nodiscard]] CamSpec read(const MotionSpec& motion) const {
        check_lift(source_, kind_, variant_, motion);
        if (kind_.only_drd && motion.type != MotionType::drd)
            source_.fail_member("cam.type", fmt::format("found \"{}\" with the motion \"{}\"; allowed: the "
                                                        "motion \"DRD\"",
                                                        kind_.type, name_of(motion.type)));
        CamSpec spec = variant_.spec();
        refuse_foreign();
        for (const CamNumber& number : variant_.numbers)
            if (number.owned && number.index >= 0)
                read_one(number, motion.lift, spec.dimensions[number.index].value);
        for (const CamChoice& choice : variant_.choices)
            if (const auto given = source_.find(choice.table, choice.key))
                spec.choices[choice.key] = given->value().text;
        return kind_.add_given ? with_given(spec) : spec;
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
        const auto refused = std::ranges::find(kind_.refused, word, &CamSynonym::word);
        const std::string why = refused == kind_.refused.end() ? "" : fmt::format(" ({})", refused->meant);
        source_.fail_member(fmt::format("{}.{}", kind_.choosing_table, kind_.choosing_key),
                            fmt::format("found \"{}\" for a cam of type \"{}\"{}; allowed: {}", word,
                                        kind_.type, why, quoted_choices(allowed)));
    }
    /// Including the numbers that are not dimensions of the spec.
    [[nodiscard]] CamSpec with_given(const CamSpec& spec) const {
        std::map<std::string, double> given;
        for (const CamNumber& number : variant_.numbers)
            if (number.owned && number.index < 0)
                if (const auto found = source_.find(number.table, number.key))
                    given[number.key] = found->number();
        try {
            return kind_.add_given(spec, given);
        } catch (const SceneError& error) {
            source_.fail_member(error.fault().member, words_of(error.fault()));
        }
    }
    /// The variants of the kind with this number: only with "a" or "b"; none: omit it.
    [[nodiscard]] std::string allowed_with(const std::string& key) const {
        std::vector<std::string_view> words;
        for (const CamVariant& one : kind_.variants)
            for (const CamNumber& number : one.numbers)
                if (number.owned && number.key == key) words.emplace_back(one.word);
        return words.empty() ? "leave it out" : "only with " + quoted_choices(words);
    }
    /// Keys of the other variants.
    void refuse_foreign() const {
        const auto refuse = [&](const auto& entry) {
            const auto given = source_.find(entry.table, entry.key);
            if (entry.owned || !given) return;
            source_.fail(given->member->place, joined_key(entry.table, given->member->name),
                         fmt::format("found a key that {} does not have; allowed: {}", variant_.spoken,
                                     allowed_with(entry.key)));
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
            source_.fail(source_.table(number.table)->place, joined_key(number.table, row->first_key()),
                         fmt::format("missing for {}; allowed: {}", variant_.spoken,
                                     row->allowed(row->spellings.front())));
        target = number.value.value_or(0.0) + number.per_lift * lift;
        if (!row) return;
        target.key = joined_key(number.table, row->first_key());
        target.unit = row->spellings.front().factor;
    }
};

/// Of an engine or a vibration: of any lift.
bool is_frequency(std::string_view unit) {
    return unit == "Hz" || unit == "rpm" || unit == "rad/s";
}

/// The keys of the train or of one of its stages: units, and a mass.
void check_train(const SceneSource& source, const Node& table, std::string_view path,
                 const MotionSpec& motion) {
    bool has_mass = false;
    for (const Member& member : table.members) {
        const KeyMatch key = match_key(path, member.name);
        if (key.row == nullptr) continue;
        if (!is_frequency(key.spelling->unit))
            check_unit(source, {&member, key.row, key.spelling}, "dynamics." + member.name, motion);
        has_mass = has_mass || key.row->name == "mass" || key.row->name == "inertia";
    }
    if (!has_mass) {
        const std::array masses = {find_row(path, "mass")->names(), find_row(path, "inertia")->names()};
        source.fail(
            table.place, path,
            fmt::format("missing {}; allowed: a number > 0", fitting_keys(masses, motion.lift_is_angle)));
    }
}

}  // namespace

void check_lift(const SceneSource& source, const CamKind& kind, const CamVariant& variant,
                const MotionSpec& motion) {
    if (variant.swings == motion.lift_is_angle) return;
    const std::string& allowed = motion.lift_is_angle ? kind.with_angle : kind.with_length;
    const std::array lift = {KeyNames{"motion.lift", find_row("motion", "lift")->spellings}};
    source.fail_member(
        kind.choosing_key.empty() ? "cam.type" : fmt::format("{}.{}", kind.choosing_table, kind.choosing_key),
        fmt::format("found \"{}\" where the lift is {}; allowed: {}{}{}{}", variant.word,
                    length_or_angle(motion.lift_is_angle), allowed, allowed.empty() ? "" : ", or ",
                    fitting_keys(lift, !motion.lift_is_angle), kind.lift_remark));
}

CamSpec read_mechanism(const SceneSource& source, const CamKind& kind, const MotionSpec& motion) {
    return MechanismReader(source, kind).read(motion);
}

void read_dynamics(const SceneSource& source, Scene& scene) {
    check_train(source, *source.table("dynamics"), "dynamics", scene.motion);
    check_speed_range(source, "dynamics");
    if (const auto stages = source.find("dynamics", "stage"))
        for (const Node& stage : stages->value().items) {
            check_train(source, stage, "dynamics.stage", scene.motion);
            if (!source.find_in(stage, "dynamics.stage", "stiffness"))
                source.fail(stage.place, "dynamics.stage", "missing stiffness; allowed: a number > 0");
        }
    read_scaled_rows(source, "dynamics", scene, {});
}

}  // namespace camopt::input
