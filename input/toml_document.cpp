// SPDX-License-Identifier: MIT
// The only source that sees toml++ (header-only here, so that nothing is needed at run time).
#define TOML_HEADER_ONLY 1
#include "core/errors.hpp"
#include "input/document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <tuple>

namespace camopt::input {
namespace {

// toml++ bounds the nesting of inline values (256) but not the parts of a dotted key; its tables are
// destroyed recursively, so a key of 10⁵ parts overflows the stack. No scene needs more than four.
constexpr int most_key_dots = 100;

Place place_of(const toml::source_position& position) {
    return {.line = std::max(1, static_cast<int>(position.line)),
            .column = std::max(1, static_cast<int>(position.column)),
            .override_text = {}};
}

/// Throws where a run of dotted text is longer than any key may be.
void refuse_deep_keys(std::string_view toml, std::string_view source_name) {
    Place place;
    int dots = 0;
    for (const char letter : toml) {
        if (letter == '.') ++dots;
        if (dots > most_key_dots)
            throw InputError(error_prefix(source_name, place, "") +
                             fmt::format("TOML: found more than {} dots in one key or word", most_key_dots));
        if (std::string_view(",=[]{}\n").find(letter) != std::string_view::npos) dots = 0;
        ++place.column;
        if (letter == '\n') place = {.line = place.line + 1, .column = 1, .override_text = {}};
    }
}

Node converted(const toml::node& source);

void convert_members(const toml::table& source, Node& node) {
    for (const auto& [key, value] : source)
        node.members.push_back({std::string(key.str()), place_of(key.source().begin), converted(value)});
    std::ranges::stable_sort(node.members, {}, [](const Member& member) {
        return std::tuple(member.place.line, member.place.column);
    });
}

Node converted(const toml::node& source) {
    Node node;
    node.place = place_of(source.source().begin);
    switch (source.type()) {
        case toml::node_type::table:
            convert_members(*source.as_table(), node);
            break;
        case toml::node_type::array:
            node.kind = NodeKind::array;
            for (const toml::node& item : *source.as_array()) node.items.push_back(converted(item));
            break;
        case toml::node_type::string:
            node.kind = NodeKind::text;
            node.text = source.as_string()->get();
            break;
        case toml::node_type::integer:
            node.kind = NodeKind::integer;
            node.integer = source.as_integer()->get();
            break;
        case toml::node_type::floating_point:
            node.kind = NodeKind::number;
            node.number = source.as_floating_point()->get();
            break;
        case toml::node_type::boolean:
            node.kind = NodeKind::boolean;
            node.boolean = source.as_boolean()->get();
            break;
        default:
            node.kind = NodeKind::date_or_time;
            break;
    }
    return node;
}

void set_place(Node& node, const Place& place) {
    node.place = place;
    for (Node& item : node.items) set_place(item, place);
    for (Member& member : node.members) {
        member.place = place;
        set_place(member.value, place);
    }
}

bool is_bare_word(std::string_view text) {
    const auto is_letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    const auto is_rest = [&](char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '.' || c == '-';
    };
    return !text.empty() && is_letter(text.front()) && std::ranges::all_of(text, is_rest);
}

}  // namespace

Node parse_document(std::string_view toml, std::string_view source_name) {
    refuse_deep_keys(toml, source_name);
    try {
        return converted(toml::parse(toml, source_name));
    } catch (const toml::parse_error& error) {
        throw InputError(error_prefix(source_name, place_of(error.source().begin), "") +
                         fmt::format("TOML: {}", error.description()));
    }
}

Node parse_override_value(std::string_view value, const Place& place) {
    Node result;
    try {
        const std::string line = fmt::format("value = {}\n", value);
        refuse_deep_keys(line, "");
        const Node document = converted(toml::parse(std::string_view(line), std::string_view()));
        if (document.members.size() != 1)
            throw InputError(error_prefix("", place, "") +
                             "found more than one line; allowed: one TOML value");
        result = document.members.front().value;
    } catch (const toml::parse_error&) {
        if (!is_bare_word(value))
            throw InputError(
                error_prefix("", place, "") +
                "found no TOML value; allowed: a number, true, false, a word, a \"text\" or an [array]");
        result.kind = NodeKind::text;
        result.text = value;
    }
    set_place(result, place);
    return result;
}

}  // namespace camopt::input
