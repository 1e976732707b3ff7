// SPDX-License-Identifier: MIT
#include "input/overrides.hpp"

#include "core/errors.hpp"
#include "input/scene_source.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt::input {
namespace {

constexpr std::string_view example = "KEY=VALUE, for example motion.rise_deg=90";

[[noreturn]] void fail(const Place& place, std::string_view key, std::string_view what) {
    throw InputError(error_prefix("", place, key) + std::string(what));
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string> key_parts(std::string_view key, const Place& place) {
    std::vector<std::string> parts(1);
    for (const char letter : key) {
        if (letter == '.')
            parts.emplace_back();
        else
            parts.back() += letter;
    }
    const auto is_bare = [](const std::string& part) {
        return !part.empty() && std::ranges::all_of(part, [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                   c == '-';
        });
    };
    // No scene has deeper keys, and every part is a level of recursion later.
    constexpr std::size_t most_parts = 8;
    if (!std::ranges::all_of(parts, is_bare) || parts.size() > most_parts)
        fail(place, "", fmt::format("found no dotted key before '='; allowed: {}", example));
    return parts;
}

bool says_the_same(std::string_view table, std::string_view one, std::string_view other) {
    const KeyRow* a = match_key(table, one).row;
    const KeyRow* b = match_key(table, other).row;
    if (!a || !b) return one == other;
    return a == b || a->instead_of == b->name || b->instead_of == a->name;
}

void set(Node& table, std::string_view table_path, const std::string& name, Node value) {
    const auto same = [&](const Member& member) { return says_the_same(table_path, name, member.name); };
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

void apply_overrides(Node& root, std::span<const std::string> overrides) {
    for (const std::string& text : overrides) {
        const Place place{.line = 1, .column = 1, .override_text = text};
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos) fail(place, "", fmt::format("found no '='; allowed: {}", example));
        const std::vector<std::string> parts =
            key_parts(trimmed(std::string_view(text).substr(0, equals)), place);
        Node value = parse_override_value(trimmed(std::string_view(text).substr(equals + 1)), place);
        Node* table = &root;
        std::string path;
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
            path = joined_key(path, parts[i]);
            if (!table->find(parts[i])) {
                table->members.push_back({parts[i], place, {}});
                table->members.back().value.place = place;
            }
            table = &table->find(parts[i])->value;
            if (table->kind != NodeKind::table)
                fail(place, path,
                     fmt::format("found {}, not a table; allowed: set {} as a whole", table->shown(), path));
        }
        set(*table, path, parts.back(), std::move(value));
    }
}

}  // namespace camopt::input
