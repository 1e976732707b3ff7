// SPDX-License-Identifier: MIT
#include "input/document.hpp"

#include "core/errors.hpp"

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
    std::string shown = "\"";
    for (const char letter : text.substr(0, longest_shown_text)) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            shown += '\\';
            shown += letter;
        } else if (code < 0x20 || code == 0x7f) {
            shown += fmt::format("\\u{:04x}", code);
        } else {
            shown += letter;
        }
    }
    return shown + (text.size() > longest_shown_text ? "…\"" : "\"");
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
    const std::string where = place.override_text.empty()
                                  ? fmt::format("{}:{}:{}: ", source_name, place.line, place.column)
                                  : fmt::format("--set {}: ", place.override_text);
    return key.empty() ? where : fmt::format("{}{}: ", where, key);
}

}  // namespace camopt::input
