// SPDX-License-Identifier: MIT
#include "input/document/document.hpp"

#include "core/errors.hpp"
#include "core/text/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

// Long texts are cut: the reader of a message needs to recognise the value, not to read it again.
constexpr std::size_t longest_shown_text = 60;

std::string shown_text(const std::string& text) {
    std::size_t length = std::min(text.size(), longest_shown_text);
    while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xc0U) == 0x80U)
        --length;  // no half letter
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

}  // namespace

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

}  // namespace camopt::input
