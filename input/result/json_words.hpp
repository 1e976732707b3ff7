// SPDX-License-Identifier: MIT
// A JSON value in words, for messages.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace camopt::input {

/// The value as it is written, cut where it is long; an object or a list by what it is.
[[nodiscard]] std::string json_words(const nlohmann::ordered_json& value);

}  // namespace camopt::input
