// SPDX-License-Identifier: MIT
// What the page is told of a solve.
#pragma once

#include "studies/delivered/solution.hpp"

#include <nlohmann/json.hpp>

#include <span>
#include <string>

namespace camopt::apps {

/// scene: the scene as solved, TOML; controls: studio_controls.hpp; result: as result.json; laws: of those
/// asked for key, title, misfit (why it does not fit, or null) and curves; curves: the motion. Throws
/// InputError for a law that is not in the catalogue.
[[nodiscard]] nlohmann::ordered_json studio_answer(const Solution& solution, const std::string& text,
                                                   std::span<const std::string> laws);

}  // namespace camopt::apps
