// SPDX-License-Identifier: MIT
// The description of a kind of cam for generic code: it drives the reader of scene files, its key table, its
// messages and lists; data without formulas. Each kind describes itself in its leaf (profiles/…); the
// registry (profiles/kinds/cam_kinds.hpp) lists them all.
#pragma once

#include "scene/cam_mechanism.hpp"
#include "scene/key_row.hpp"

namespace camopt {

/// A number of a variant, and its key in a scene file.
struct CamNumber {
    std::string table, key;  ///< "cam", "cylinder_radius"; no key: not in scene files
    bool owned = true;       ///< false: the kind has such a key, but not this variant
    /// Default in SI: value + per_lift · lift. None: it is required.
    std::optional<double> value = {};
    double per_lift = 0.0;
    int index = -1;  ///< of the dimension in the spec; -1: none, CamKind::add_given takes it
};

/// A word of a variant, stored under its key in CamSpec::choices.
struct CamChoice {
    std::string table, key;
    bool owned = true;
};

/// A follower, a linkage: the choice of a scene within a kind.
struct CamVariant {
    std::string word;    ///< "translating_roller", "lever"; of a kind with no choice its type
    std::string spoken;  ///< in messages: the linkage "lever"
    bool swings = false;
    std::string touches_with;  ///< "a roller"
    std::vector<CamNumber> numbers;
    std::vector<CamChoice> choices;
    /// Every number at 0, without formulas.
    std::function<CamSpec()> spec = {};
};

/// Another word that users write for one of this program.
struct CamSynonym {
    std::string_view word, meant;
};

/// What a cam can be exported as.
enum class CamOutput {
    outline,       ///< a plane curve: table, picture, DXF
    sheet,         ///< a workshop drawing
    second_sheet,  ///< another of a second disk
    solid,         ///< a solid or its flanks (STEP)
    program        ///< the NC program that mills it
};

struct CamKind {
    std::string type;    ///< cam.type
    std::string spoken;  ///< as a list of kinds names it: "a disk cam with its follower"; empty: its type
    /// The key whose word chooses the variant; empty: there is but one.
    std::string choosing_table, choosing_key;
    std::vector<CamVariant> variants;
    /// Allowed texts if the lift is an angle, a length, and does not fit; empty: no other variant fits.
    std::string with_angle, with_length;
    std::string
        lift_remark;  ///< the meaning of its lift, after the keys of a length: ", the stroke of its feeder"
    bool has_rotation = true;
    bool only_drd = false;
    /// What can be made of a cam of this kind besides its motion; of some variants perhaps less.
    std::vector<CamOutput> outputs = {CamOutput::outline};
    /// Its own keys. Where an earlier kind has the key too, its texts follow those of the earlier one.
    std::vector<KeyRow> rows;
    std::vector<CamSynonym> also_called;   ///< of keys in [cam]
    std::vector<CamSynonym> parts_called;  ///< of parts of its variants' words
    /// Words for a variant that cannot be, each with the reason.
    std::vector<CamSynonym> refused = {};
    /// Puts the numbers without an index that a scene gives, SI by their keys, into a spec that has all else.
    /// Throws SceneError for one that does not fit. None: there are no such numbers.
    std::function<CamSpec(const CamSpec& spec, const std::map<std::string, double>& given)> add_given = {};
    /// Makes the formulas of a spec of this kind; none: its row in profiles/kinds has them.
    std::function<std::shared_ptr<const CamMechanism>(const CamSpec& spec)> formulas = {};

    [[nodiscard]] bool gives(CamOutput output) const {
        return std::ranges::find(outputs, output) != outputs.end();
    }
    /// Whether a scene with this kind may have the key.
    [[nodiscard]] bool knows(std::string_view table, std::string_view key) const {
        const auto is_it = [&](const auto& entry) { return entry.table == table && entry.key == key; };
        if (table == "cam" && (key == "type" || key == "piece" || (key == "rotation" && has_rotation)))
            return true;
        if (table == "cam.piece") return true;
        if (!choosing_key.empty() && table == choosing_table && key == choosing_key) return true;
        if (table.empty()) return key == choosing_table && key != "cam";
        return std::ranges::any_of(variants, [&](const CamVariant& variant) {
            return std::ranges::any_of(variant.numbers, is_it) || std::ranges::any_of(variant.choices, is_it);
        });
    }
    /// The variant chosen by a word; null: none.
    [[nodiscard]] const CamVariant* variant(std::string_view word) const {
        const auto found = std::ranges::find(variants, word, &CamVariant::word);
        return found == variants.end() ? nullptr : &*found;
    }
};

}  // namespace camopt
