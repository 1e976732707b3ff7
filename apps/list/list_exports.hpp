// SPDX-License-Identifier: MIT
// camopt list columns, camopt list controllers: what `export --csv` and `export --plc` know, from their
// tables.
#pragma once

#include "output/json/json_text.hpp"

#include <string>

namespace camopt::apps {

[[nodiscard]] std::string columns_text();
/// Each: key, meaning, needs (null: nothing).
[[nodiscard]] Json columns_json();

[[nodiscard]] std::string controllers_text();
/// Each: key, files, controller, rule, numbers, degree, element, limit (null: none).
[[nodiscard]] Json controllers_json();

}  // namespace camopt::apps
