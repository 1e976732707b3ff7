// SPDX-License-Identifier: MIT
// What the studio calls the keys of a scene, and in which units it takes and shows their numbers.
#include "apps/studio/studio_controls.hpp"
#include "core/text/list_text.hpp"
#include "report/view/number_text.hpp"
#include "scene/part_names.hpp"

namespace camopt::apps {

namespace {

// Tables whose key is not their name.
constexpr std::pair<std::string_view, std::string_view> named_tables[] = {{"dynamics", "follower train"},
                                                                          {"reference", "reference values"}};

/// What lies in its own table needs no other name: "keyway".
std::string table_words(std::string_view table) {
    if (table.find('[') != std::string_view::npos) return listed_words(table);
    const std::string_view name = table.substr(table.rfind('.') + 1);
    const auto* const named =
        std::ranges::find(named_tables, name, [](const auto& one) { return one.first; });
    return named == std::end(named_tables) ? words_of(name) : std::string(named->second);
}

bool ends_with_bound(std::string_view key, std::string_view bound, std::string& words) {
    if (!key.ends_with(bound)) return false;
    words = words_of(key.substr(0, key.size() - bound.size()));
    return true;
}

std::string key_name(const KeyRow& row) {
    if (!row.label.empty()) return std::string(row.label);
    std::string words;
    if (ends_with_bound(row.name, "_max", words)) return "largest " + words;
    if (ends_with_bound(row.name, "_min", words)) return "least " + words;
    if (row.table == "limits") return "largest " + words_of(row.name);
    if (row.table == "objective") return "weight of " + words_of(row.name);
    return words_of(row.name);
}

}  // namespace

ControlWords control_words(std::string_view table, const KeyRow& row, std::string_view unit) {
    ControlWords words;
    words.group = capitalised(table_words(table));
    words.name = key_name(row);
    words.unit = unit_words(unit);
    words.label = words.name + (words.unit.empty() ? "" : ", " + words.unit);
    const bool listed = table.find('[') != std::string_view::npos;
    if (!listed) words.name = capitalised(words.name);
    words.label = listed ? words.group + ": " + words.label : capitalised(words.label);
    return words;
}

}  // namespace camopt::apps
