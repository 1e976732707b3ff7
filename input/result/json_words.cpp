// SPDX-License-Identifier: MIT
#include "input/result/json_words.hpp"

#include "core/text/printable.hpp"

#include <fmt/format.h>

namespace camopt::input {

namespace {

constexpr std::size_t longest_shown = 60;

}  // namespace

std::string json_words(const nlohmann::ordered_json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return fmt::format("a list of {}", value.size());
    const std::string text =
        printable(value.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace));
    return text.size() <= longest_shown ? text : text.substr(0, longest_shown) + "...";
}

}  // namespace camopt::input
