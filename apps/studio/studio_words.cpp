// SPDX-License-Identifier: MIT
// What the studio calls the keys of a scene, and in which units it takes and shows their numbers.
#include "apps/studio/studio_controls.hpp"
#include "core/text/list_text.hpp"
#include "output/view/number_text.hpp"
#include "scene/limit_table.hpp"
#include "scene/part_names.hpp"

namespace camopt::apps {

namespace {

struct NamedKey {
    std::string_view table, key, words;  ///< an empty table: any
};

// Names that do not follow from the key; the first fitting row counts.
constexpr std::array named_keys = {
    NamedKey{"motion", "type", "kind of motion"},
    NamedKey{"motion", "rise", "rise, cam angle"},
    NamedKey{"motion", "return", "return, cam angle"},
    NamedKey{"motion", "speed", "cam speed"},
    NamedKey{"motion", "symmetric", "symmetric motion"},
    NamedKey{"motion", "within_lift", "each stroke stays between its ends"},
    NamedKey{"motion", "monotone", "no reversal within a stroke"},
    NamedKey{"motion", "closed", "closed after one revolution"},
    NamedKey{"motion.segments", "angle", "cam angle"},
    NamedKey{"motion.segments", "to", "displacement at its end"},
    NamedKey{"motion.via", "at", "cam angle"},
    NamedKey{"motion.segments.via", "at", "cam angle from the segment's start"},
    NamedKey{"", "from", "from cam angle"},
    NamedKey{"", "to", "to cam angle"},
    NamedKey{"spline", "continuity", "continuous derivatives"},
    NamedKey{"spline", "knots", "breakpoints"},
    NamedKey{"spline", "end_jerk", "jerk at the ends"},
    NamedKey{"spline", "design", "variables of the search"},
    NamedKey{"objective", "reference", "reference law"},
    NamedKey{"objective", "tie_break", "choice among equal curves"},
    NamedKey{"cam", "type", "kind of cam"},
    NamedKey{"cam", "form", "how the roller is held"},
    NamedKey{"cam", "rotation", "sense of rotation"},
    NamedKey{"linkage", "type", "kind of linkage"},
    NamedKey{"forces", "cam_modulus", "Young's modulus of the cam"},
    NamedKey{"forces", "follower_modulus", "Young's modulus of the follower"},
    NamedKey{"forces", "cam_poisson", "Poisson's ratio of the cam"},
    NamedKey{"forces", "follower_poisson", "Poisson's ratio of the follower"},
    NamedKey{"measured", "table", "table (CSV file)"},
    NamedKey{"measured", "use", "used to"},
    NamedKey{"drawing", "bore", "bore diameter"},
    NamedKey{"drawing", "datum", "datum mark, cam angle"},
    NamedKey{"drawing.keyway", "at", "cam angle of its middle"},
    NamedKey{"limits", "residual", "largest residual vibration"},
    NamedKey{"solver", "name", "solver"},
    NamedKey{"solver", "gap", "proved gap"},
    NamedKey{"solver", "max_seconds", "time limit, s"},
    NamedKey{"solver", "explain_seconds", "time for suggested changes, s"},
    NamedKey{"solver", "explain_changes", "suggested changes"},
    NamedKey{"solver", "starts", "starting points"},
    NamedKey{"solver", "seed", "seed of the starting points"},
};

// Tables whose key is not their name.
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> named_tables = {
    {{"dynamics", "follower train"}, {"reference", "reference values"}}};

/// What lies in its own table needs no other name: "keyway".
std::string table_words(std::string_view table) {
    if (table.find('[') != std::string_view::npos) return listed_words(table);
    const std::string_view name = table.substr(table.rfind('.') + 1);
    const auto named = std::ranges::find(named_tables, name, [](const auto& one) { return one.first; });
    return named == named_tables.end() ? words_of(name) : std::string(named->second);
}

bool ends_with_bound(std::string_view key, std::string_view bound, std::string& words) {
    if (!key.ends_with(bound)) return false;
    words = words_of(key.substr(0, key.size() - bound.size()));
    return true;
}

std::string key_name(std::string_view table, std::string_view key) {
    for (const NamedKey& named : named_keys)
        if (named.key == key && (named.table.empty() || named.table == table))
            return std::string(named.words);
    if (const LimitRow* const limit = table == "limits" ? limit_named(key) : nullptr; limit && limit->words)
        return limit->words;
    std::string words;
    if (ends_with_bound(key, "_max", words)) return "largest " + words;
    if (ends_with_bound(key, "_min", words)) return "least " + words;
    if (table == "limits") return "largest " + words_of(key);
    if (table == "objective") return "weight of " + words_of(key);
    return words_of(key);
}

}  // namespace

ControlWords control_words(std::string_view table, std::string_view path, std::string_view key,
                           std::string_view unit) {
    ControlWords words;
    words.group = capitalised(table_words(table));
    words.name = key_name(path, key);
    words.unit = unit_words(unit);
    words.label = words.name + (words.unit.empty() ? "" : ", " + words.unit);
    const bool listed = table.find('[') != std::string_view::npos;
    if (!listed) words.name = capitalised(words.name);
    words.label = listed ? words.group + ": " + words.label : capitalised(words.label);
    return words;
}

}  // namespace camopt::apps
