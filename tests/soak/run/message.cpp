// SPDX-License-Identifier: MIT
#include "tests/soak/run/message.hpp"

#include <nlohmann/json.hpp>

namespace camopt::soak {

using nlohmann::json;

std::string message_line(const std::vector<std::string>& fields) {
    return json(fields).dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
}

std::vector<std::string> message_fields(const std::string& line) {
    const json fields = json::parse(line, nullptr, false);  // a worker may die within a line
    return fields.is_array() ? fields.get<std::vector<std::string>>() : std::vector<std::string>{""};
}

}  // namespace camopt::soak
