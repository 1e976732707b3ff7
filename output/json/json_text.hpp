// SPDX-License-Identifier: MIT
// How camopt writes JSON: keys in the given order, lists of plain values on one line, and null for every
// number that is not finite. Private to output/: the JSON library stays out of the public headers.
#pragma once

#include "core/numbers/extremum.hpp"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace camopt {

using Json = nlohmann::ordered_json;

[[nodiscard]] Json number_json(double value);
[[nodiscard]] Json number_json(const std::optional<double>& value);
/// null for text that says nothing.
[[nodiscard]] Json words_json(std::string_view text);
[[nodiscard]] Json extremum_json(const Extremum& extremum);
[[nodiscard]] Json numbers_json(std::span<const double> values);
[[nodiscard]] Json numbers_json(const Eigen::VectorXd& values);

/// Indented by two spaces; a list or object of plain values stands on one line. Ends in a line feed. Numbers
/// read back as the same double; bytes that are not UTF-8 are replaced.
[[nodiscard]] std::string json_text(const Json& value);

}  // namespace camopt
