// SPDX-License-Identifier: MIT
// What the studio calls the keys of a scene, and in which units it takes and shows their numbers.
#include "apps/studio/studio_controls.hpp"
#include "core/text/list_text.hpp"
#include "core/text/parsing.hpp"
#include "output/view/number_text.hpp"
#include "scene/limit_table.hpp"

#include <fmt/ranges.h>

#include <cctype>

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

// One table of a list, and tables whose key is not their name.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> named_tables = {
    {{"segments", "segment"},
     {"via", "set point"},
     {"dynamics", "follower train"},
     {"reference", "reference values"}}};

/// "segments[1]" is "segment 2".
std::string table_words(std::string_view part) {
    const std::size_t bracket = part.find('[');
    const std::string_view name = part.substr(0, bracket);
    const std::span tables(named_tables);
    const auto named = std::ranges::find(tables, name, &std::pair<std::string_view, std::string_view>::first);
    std::string words = named == tables.end() ? words_of(name) : std::string(named->second);
    if (bracket == std::string_view::npos) return words;
    const auto index = integer_in(part.substr(bracket + 1, part.size() - bracket - 2));
    return fmt::format("{} {}", words, index.value_or(0) + 1);
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

ControlWords control_words(std::string_view table, std::string_view key, std::string_view unit) {
    ControlWords words;
    std::string path;  // of the key table: without indices
    std::vector<std::string> parts;
    for (std::string_view rest = table; !rest.empty();) {
        const std::size_t dot = rest.find('.');
        const std::string_view part = rest.substr(0, dot);
        path += (path.empty() ? "" : ".") + std::string(part.substr(0, part.find('[')));
        parts.push_back(table_words(part));
        rest = dot == std::string_view::npos ? std::string_view() : rest.substr(dot + 1);
    }
    // What lies in its own table needs no other name: "Segment 1, set point 2", "Keyway".
    if (parts.size() > 1) parts.erase(parts.begin());
    words.group = capitalised(fmt::format("{}", fmt::join(parts, ", ")));
    words.name = key_name(path, key);
    words.unit = unit_words(unit);
    words.label = words.name + (words.unit.empty() ? "" : ", " + words.unit);
    const bool listed = table.find('[') != std::string_view::npos;
    if (!listed) words.name = capitalised(words.name);
    words.label = listed ? words.group + ": " + words.label : capitalised(words.label);
    return words;
}

}  // namespace camopt::apps
