// SPDX-License-Identifier: MIT
#include "input/document/document_text.hpp"

#include "core/errors.hpp"
#include "core/text/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt::input {
namespace {

std::string quoted(std::string_view text) {
    std::string escaped;
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') escaped += '\\';
        escaped += letter;
    }
    return '"' + printable(escaped) + '"';  // what it writes out is TOML's own spelling
}

bool is_bare(std::string_view name) {
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return !name.empty() && name.find_first_not_of(letters) == std::string_view::npos;
}

std::string key_text(std::string_view name) {
    return is_bare(name) ? std::string(name) : quoted(name);
}

std::string number_text(double number) {
    if (std::isnan(number)) return "nan";
    std::string text = fmt::format("{}", number);
    if (std::isfinite(number) && text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string list_text(const Node& node) {
    std::string text;
    if (node.kind == NodeKind::array) {
        for (const Node& item : node.items) text += (text.empty() ? "" : ", ") + value_text(item);
        return "[" + text + "]";
    }
    for (const Member& member : node.members)
        text += (text.empty() ? "" : ", ") + key_text(member.name) + " = " + value_text(member.value);
    return "{" + text + "}";
}

}  // namespace

std::string value_text(const Node& node) {
    switch (node.kind) {
        case NodeKind::boolean:
            return node.boolean ? "true" : "false";
        case NodeKind::integer:
            return fmt::to_string(node.integer);
        case NodeKind::number:
            return number_text(node.number);
        case NodeKind::text:
            return quoted(node.text);
        case NodeKind::array:
        case NodeKind::table:
            return list_text(node);
        case NodeKind::date_or_time:
            break;
    }
    throw InputError("a scene is written as TOML: found a date or time; allowed: what scenes hold");
}

namespace {

void append(std::string& text, const std::vector<Member>& members, bool tables) {
    for (const Member& member : members)
        if (tables || member.value.kind != NodeKind::table)
            text += key_text(member.name) + " = " + value_text(member.value) + "\n";
}

}  // namespace

std::string document_text(const Node& root) {
    std::string text;
    append(text, root.members, false);
    for (const Member& member : root.members) {
        if (member.value.kind != NodeKind::table) continue;
        text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", key_text(member.name));
        append(text, member.value.members, true);
    }
    return text;
}

}  // namespace camopt::input
