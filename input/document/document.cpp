// SPDX-License-Identifier: MIT
#include "input/document/document.hpp"

#include "core/text/list_text.hpp"
#include "core/text/printable.hpp"

#include <fmt/format.h>

namespace camopt::input {

const Member* Node::find(std::string_view name) const {
    const auto found = std::ranges::find(members, name, &Member::name);
    return found == members.end() ? nullptr : &*found;
}

Member* Node::find(std::string_view name) {
    const auto found = std::ranges::find(members, name, &Member::name);
    return found == members.end() ? nullptr : &*found;
}

double Node::as_number() const {
    return kind == NodeKind::integer ? static_cast<double>(integer) : number;
}

namespace {

// Long texts are truncated: the message identifies the value.
constexpr std::size_t longest_shown_text = 60;

std::string shown_text(const std::string& text) {
    std::size_t length = std::min(text.size(), longest_shown_text);
    while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xc0U) == 0x80U)
        --length;  // no partial UTF-8 character
    std::string escaped;
    for (const char letter : text.substr(0, length)) {
        if (letter == '"' || letter == '\\') escaped += '\\';
        escaped += letter;
    }
    return '"' + printable(escaped) + (length < text.size() ? "…\"" : "\"");
}

std::string shown_number(double number) {
    std::string shown = fmt::format("{}", number);
    if (std::isfinite(number) && shown.find_first_of(".e") == std::string::npos) shown += ".0";
    return shown;
}

std::string quoted_text(std::string_view text) {
    std::string escaped;
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') escaped += '\\';
        escaped += letter;
    }
    return '"' + printable(escaped) + '"';  // output uses TOML's own spelling
}

bool is_bare(std::string_view name) {
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return !name.empty() && name.find_first_not_of(letters) == std::string_view::npos;
}

std::string key_text(std::string_view name) {
    return is_bare(name) ? std::string(name) : quoted_text(name);
}

std::string number_text(double number) {
    if (std::isnan(number)) return "nan";
    std::string text = fmt::format("{}", number);
    if (std::isfinite(number) && text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string list_text(const Node& node) {
    if (node.kind == NodeKind::array) return "[" + listed(node.items, ", ", value_text) + "]";
    return "{" +
           listed(node.members, ", ",
                  [](const Member& member) {
                      return key_text(member.name) + " = " + value_text(member.value);
                  }) +
           "}";
}

bool is_tables(const Node& node) {
    return node.kind == NodeKind::array && !node.items.empty() && node.items.front().kind == NodeKind::table;
}

std::string lines_text(const Node& node, TableEntries entries) {
    if (entries == TableEntries::in_one_line || !is_tables(node)) return value_text(node);
    std::string text = "[\n";
    for (const Node& item : node.items) text += "    " + value_text(item) + ",\n";
    return text + "]";
}

void append(std::string& text, const std::vector<Member>& members, bool tables, TableEntries entries) {
    for (const Member& member : members)
        if (tables || member.value.kind != NodeKind::table)
            text += key_text(member.name) + " = " + lines_text(member.value, entries) + "\n";
}

Node node_of(NodeKind kind) {
    Node node;
    node.kind = kind;
    return node;
}

}  // namespace

Node boolean_node(bool value) {
    Node node = node_of(NodeKind::boolean);
    node.boolean = value;
    return node;
}

Node integer_node(long long value) {
    Node node = node_of(NodeKind::integer);
    node.integer = value;
    return node;
}

Node number_node(double value) {
    // Larger integers may not be exact doubles.
    constexpr double exact_integers = 9007199254740992.0;
    if (value == std::trunc(value) && std::abs(value) <= exact_integers)
        return integer_node(static_cast<long long>(value));
    Node node = node_of(NodeKind::number);
    node.number = value;
    return node;
}

Node text_node(std::string_view text) {
    Node node = node_of(NodeKind::text);
    node.text = text;
    return node;
}

std::string Node::shown() const {
    switch (kind) {
        case NodeKind::boolean:
            return boolean ? "true" : "false";
        case NodeKind::integer:
            return fmt::to_string(integer);
        case NodeKind::number:
            return shown_number(number);
        case NodeKind::text:
            return shown_text(text);
        case NodeKind::array:
            return "an array";
        case NodeKind::date_or_time:
            return "a date or time";
        case NodeKind::table:
            break;
    }
    return "a table";
}

std::string error_prefix(std::string_view source_name, const Place& place, std::string_view key) {
    std::string where;
    if (!place.override_text.empty())
        where = fmt::format("--set {}: ", printable_lines(place.override_text));
    else if (place.setting == 0)
        where = fmt::format("{}:{}:{}: ", printable(source_name), place.line, place.column);
    return key.empty() ? where : fmt::format("{}{}: ", where, printable(key));
}

std::string value_text(const Node& node) {
    switch (node.kind) {
        case NodeKind::boolean:
            return node.boolean ? "true" : "false";
        case NodeKind::integer:
            return fmt::to_string(node.integer);
        case NodeKind::number:
            return number_text(node.number);
        case NodeKind::text:
            return quoted_text(node.text);
        case NodeKind::array:
        case NodeKind::table:
            return list_text(node);
        case NodeKind::date_or_time:
            break;
    }
    throw InputError("a scene is written as TOML: found a date or time; allowed: the value types of a scene");
}

std::string document_text(const Node& root, TableEntries entries) {
    std::string text;
    append(text, root.members, false, entries);
    for (const Member& member : root.members) {
        if (member.value.kind != NodeKind::table) continue;
        text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", key_text(member.name));
        append(text, member.value.members, true, entries);
    }
    return text;
}

}  // namespace camopt::input
