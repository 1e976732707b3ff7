// SPDX-License-Identifier: MIT
#include "core/text/parsing.hpp"
#include "core/text/printable.hpp"
#include "input/document/scene_source.hpp"

#include <fmt/format.h>

#include <charconv>

namespace camopt::input {
namespace {

constexpr std::string_view example = "KEY=VALUE, for example motion.rise_deg=90 or motion.segments[1].to=0.5";

[[noreturn]] void fail(const Place& place, std::string_view key, std::string_view what) {
    throw PlacedError(place, error_prefix("", place, key) + std::string(what));
}

/// "segments[1]": an entry of an array.
struct KeyPart {
    std::string name;
    std::optional<std::size_t> index;
};

/// Nullopt if the text is not a name, or not a name with an index.
std::optional<KeyPart> key_part(std::string_view text) {
    KeyPart part;
    if (const std::size_t bracket = text.find('['); bracket != std::string_view::npos) {
        const std::string_view digits = text.substr(bracket + 1);
        std::size_t index = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
        if (error != std::errc() || end == digits.data() + digits.size() ||
            std::string_view(end, digits.data() + digits.size()) != "]")
            return std::nullopt;
        part.index = index;
        text = text.substr(0, bracket);
    }
    const auto is_bare = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
    };
    if (text.empty() || !std::ranges::all_of(text, is_bare)) return std::nullopt;
    part.name = text;
    return part;
}

std::vector<KeyPart> key_parts(std::string_view key, const Place& place) {
    // No scene has deeper keys; every part costs a level of recursion.
    constexpr std::size_t most_parts = 8;
    const std::string_view whole = key;
    std::vector<KeyPart> parts;
    while (parts.size() <= most_parts) {
        const std::size_t dot = key.find('.');
        std::optional<KeyPart> part = key_part(key.substr(0, dot));
        if (!part) break;
        parts.push_back(std::move(*part));
        if (dot == std::string_view::npos && parts.size() <= most_parts) return parts;
        key.remove_prefix(dot + 1);
    }
    if (place.setting != 0)
        fail(place, "",
             fmt::format("found \"{}\", which is not a dotted key; allowed: for example motion.rise_deg or "
                         "motion.segments[1].to",
                         printable(whole)));
    fail(place, "", fmt::format("found no dotted key before '='; allowed: {}", example));
}

bool says_the_same(std::string_view table, std::string_view one, std::string_view other, KeyRows rows) {
    const KeyRow* a = match_key(table, one, rows).row;
    const KeyRow* b = match_key(table, other, rows).row;
    if (!a || !b) return one == other;
    return a == b || a->instead_of == b->name || b->instead_of == a->name;
}

/// The entry of an array in the table.
Node& entry(Node& table, const KeyPart& part, const std::string& path, const Place& place) {
    Member* member = table.find(part.name);
    if (!member) fail(place, path, "found no such array in the scene; allowed: an existing entry");
    Node& array = member->value;
    if (array.kind != NodeKind::array)
        fail(place, path,
             fmt::format("found {}, not an array; allowed: set {} as a whole", array.shown(), path));
    if (*part.index >= array.items.size())
        fail(place, path,
             fmt::format("found {} entries, counted from 0; allowed: an existing entry", array.items.size()));
    return array.items[*part.index];
}

/// The table for a part of the key; created if missing.
Node& inner_table(Node& table, const KeyPart& part, const std::string& path, const Place& place) {
    if (!part.index && !table.find(part.name)) {
        Place implied = place;
        if (place.setting > 0) implied.setting = -place.setting;
        table.members.push_back({part.name, implied, {}});
        table.members.back().value.place = implied;
    }
    Node& inner = part.index ? entry(table, part, path, place) : table.find(part.name)->value;
    if (inner.kind == NodeKind::table) return inner;
    const bool tables =
        inner.kind == NodeKind::array && !inner.items.empty() && inner.items[0].kind == NodeKind::table;
    fail(place, path,
         fmt::format("found {}, not a table; allowed: set {} as a whole{}", inner.shown(), path,
                     tables ? fmt::format(", or in one of its entries, {}[0] to {}[{}]", path, path,
                                          inner.items.size() - 1)
                            : ""));
}

/// The target of a key: the table that holds its last part, and both as in the key table and as written by
/// the user.
struct Destination {
    Node* table = nullptr;
    KeyPart last;
    std::string table_path;  ///< in the key table, without indices
    std::string shown_path;  ///< as the user writes it, without the index of the last part
};

Destination destination(Node& root, std::string_view key, const Place& place) {
    const std::vector<KeyPart> parts = key_parts(key, place);
    Destination found{&root, parts.back(), "", ""};
    for (const KeyPart& part : parts) {
        found.shown_path = joined_key(found.shown_path, part.name);
        if (&part == &parts.back()) break;
        const std::string array_path = found.shown_path;
        if (part.index) found.shown_path += fmt::format("[{}]", *part.index);
        found.table = &inner_table(*found.table, part, part.index ? array_path : found.shown_path, place);
        found.table_path = joined_key(found.table_path, part.name);
    }
    return found;
}

void set(const Destination& to, Node value, KeyRows rows) {
    Node& table = *to.table;
    const std::string& name = to.last.name;
    const auto same = [&](const Member& member) {
        return says_the_same(to.table_path, name, member.name, rows);
    };
    const auto found = std::ranges::find_if(table.members, same);
    if (found == table.members.end()) {
        const Place place = value.place;
        table.members.push_back({name, place, std::move(value)});
        return;
    }
    const Place place = value.place;
    *found = {name, place, std::move(value)};
    table.members.erase(std::remove_if(found + 1, table.members.end(), same), table.members.end());
}

}  // namespace

Setting parsed_setting(std::string_view text, const Place& place) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) fail(place, "", fmt::format("found no '='; allowed: {}", example));
    const std::string_view key = trimmed(text.substr(0, equals));
    (void)key_parts(key, place);  // a wrong key is reported before a wrong value
    return {std::string(key), parse_override_value(trimmed(text.substr(equals + 1)), place)};
}

void apply_setting(Node& root, const Setting& setting, KeyRows rows) {
    const Destination to = destination(root, setting.key, setting.value.place);
    if (to.last.index)
        entry(*to.table, to.last, to.shown_path, setting.value.place) = setting.value;
    else
        set(to, setting.value, rows);
}

bool remove_setting(Node& root, std::string_view key, const Place& place) {
    Node* table = &root;
    std::string table_path;
    const std::vector<KeyPart> parts = key_parts(key, place);
    for (const KeyPart& part : parts) {
        const bool last = &part == &parts.back();
        if (last && !part.index)
            return std::erase_if(table->members, [&](const Member& member) {
                       return says_the_same(table_path, part.name, member.name, scene_keys());
                   }) > 0;
        Member* const member = table->find(part.name);
        if (!member) return false;
        table_path = joined_key(table_path, part.name);
        Node& value = part.index ? entry(*table, part, table_path, place) : member->value;
        if (last) {
            std::vector<Node>& items = member->value.items;
            items.erase(items.begin() + static_cast<std::ptrdiff_t>(*part.index));
            return true;
        }
        if (value.kind != NodeKind::table) return false;
        table = &value;
    }
    return false;
}

void apply_overrides(Node& root, std::span<const std::string> overrides, KeyRows rows) {
    for (const std::string& text : overrides)
        apply_setting(root, parsed_setting(text, {.line = 1, .column = 1, .override_text = text}), rows);
}

}  // namespace camopt::input
