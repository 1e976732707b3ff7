// SPDX-License-Identifier: MIT
#include "input/document/scene_source.hpp"

#include "scene/limit_table.hpp"

#include <fmt/format.h>

#include <charconv>

namespace camopt::input {

Dimension Given::dimension() const {
    const double factor = spelling->factor;
    const auto end = [&](const char* name) { return value().find(name)->value.as_number() * factor; };
    Dimension dimension =
        value().kind == NodeKind::table ? Dimension(end("min"), end("max")) : Dimension(number());
    dimension.key = joined_key(row->table, member->name);
    dimension.unit = factor;
    return dimension;
}

const Node* SceneSource::table(std::string_view path) const {
    const Node* node = &root;
    while (!path.empty()) {
        const std::size_t dot = path.find('.');
        const Member* member = node->find(path.substr(0, dot));
        if (!member || member->value.kind != NodeKind::table) return nullptr;
        node = &member->value;
        path = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
    }
    return node;
}

std::optional<Given> SceneSource::find_in(const Node& table, std::string_view table_path,
                                          std::string_view quantity) const {
    for (const Member& member : table.members) {
        const KeyMatch match = match_key(table_path, member.name, rows);
        if (match.row && match.row->name == quantity) return Given{&member, match.row, match.spelling};
    }
    return std::nullopt;
}

std::optional<Given> SceneSource::find(std::string_view table_path, std::string_view quantity) const {
    const Node* node = table(table_path);
    return node ? find_in(*node, table_path, quantity) : std::nullopt;
}

namespace {

/// "via[1]" → "via", 1; "at" → "at", none.
std::pair<std::string_view, std::optional<std::size_t>> split_index(std::string_view part) {
    const std::size_t bracket = part.find('[');
    if (bracket == std::string_view::npos) return {part, std::nullopt};
    std::size_t index = 0;
    std::from_chars(part.data() + bracket + 1, part.data() + part.size(), index);
    return {part.substr(0, bracket), index};
}

/// Members of Scene with another name in the file ("return" is a keyword of C++), or possibly so.
std::string_view other_name(std::string_view member) {
    if (member == "return_angle") return "return";
    if (const LimitRow* row = limit_named(member)) {
        if (row->swinging.name != nullptr) return row->swinging.name;
        if (row->table != nullptr) return row->table;
    }
    if (member == "load_mass") return "load_inertia";
    if (member == "force") return "moment";
    return member == "mass" ? "inertia" : member;
}

}  // namespace

void SceneSource::fail_member(std::string_view member, std::string_view what) const {
    const Node* node = &root;
    Place place;
    std::string table_path;
    std::string key;
    for (std::string_view rest = member; !rest.empty();) {
        const std::size_t dot = rest.find('.');
        const auto [quantity, index] = split_index(rest.substr(0, dot));
        std::optional<Given> given;
        if (node) given = find_in(*node, table_path, quantity);
        if (node && !given) given = find_in(*node, table_path, other_name(quantity));
        // A table of the file is not a quantity of the key table.
        const Member* const table = node && !given ? node->find(quantity) : nullptr;
        key = joined_key(key, given ? std::string_view(given->member->name) : quantity);
        table_path = joined_key(table_path, quantity);
        node = given ? &given->value() : table ? &table->value : nullptr;
        if (index) {
            key += fmt::format("[{}]", *index);
            if (node && *index < node->items.size()) node = &node->items[*index];
        }
        if (node) place = node->place;
        rest = dot == std::string_view::npos ? std::string_view() : rest.substr(dot + 1);
    }
    fail(place, key, what);
}

}  // namespace camopt::input
