// SPDX-License-Identifier: MIT
#include "report/json/json_text.hpp"

#include "core/text/printable.hpp"

namespace camopt {

namespace {

constexpr std::size_t line_width =
    110;  // an object longer than this is broken into lines; a list of numbers never

std::string plain(const Json& value) {
    // What JSON may leave as it is, terminals need not: DEL, C1 controls, the direction of writing.
    return printable(value.dump(-1, ' ', false, Json::error_handler_t::replace));
}

bool holds_only_plain_values(const Json& value) {
    return std::none_of(value.begin(), value.end(), [](const Json& item) { return item.is_structured(); });
}

std::string one_line(const Json& value) {
    std::string text = value.is_object() ? "{ " : "[";
    bool first = true;
    for (const auto& [key, item] : value.items()) {
        if (!first) text += ", ";
        first = false;
        if (value.is_object()) text += plain(Json(key)) + ": ";
        text += plain(item);
    }
    return text + (value.is_object() ? " }" : "]");
}

void append(std::string& text, const Json& value, std::size_t indent) {
    if (!value.is_structured() || value.empty()) {
        text += plain(value);
        return;
    }
    if (holds_only_plain_values(value)) {
        std::string line = one_line(value);
        if (value.is_array() || line.size() + indent <= line_width) {
            text += line;
            return;
        }
    }
    const std::string inner(indent + 2, ' ');
    text += value.is_object() ? "{\n" : "[\n";
    bool first = true;
    for (const auto& [key, item] : value.items()) {
        if (!first) text += ",\n";
        first = false;
        text += inner;
        if (value.is_object()) text += plain(Json(key)) + ": ";
        append(text, item, indent + 2);
    }
    text += "\n" + std::string(indent, ' ') + (value.is_object() ? "}" : "]");
}

}  // namespace

Json number_json(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json number_json(const std::optional<double>& value) {
    return value ? number_json(*value) : Json(nullptr);
}

Json words_json(std::string_view text) {
    return text.empty() ? Json(nullptr) : Json(text);
}

Json extremum_json(const Extremum& extremum) {
    return {{"value", number_json(extremum.value)}, {"at", number_json(extremum.at)}};
}

Json numbers_json(std::span<const double> values) {
    Json list = Json::array();
    for (const double value : values) list.push_back(number_json(value));
    return list;
}

Json numbers_json(const Eigen::VectorXd& values) {
    return numbers_json(std::span<const double>(values.data(), static_cast<std::size_t>(values.size())));
}

std::string json_text(const Json& value) {
    std::string text;
    append(text, value, 0);
    return text + "\n";
}

}  // namespace camopt
