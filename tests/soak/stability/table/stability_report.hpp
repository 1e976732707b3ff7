// SPDX-License-Identifier: MIT
// The stability table as CSV (every row), Markdown (a summary a group, and every row that is not plain) and
// as a picture (attained error against what the row allows; condition numbers).
#pragma once

#include "tests/soak/stability/stability_row.hpp"

#include <span>
#include <string>

namespace camopt::stability {

[[nodiscard]] std::string stability_csv(std::span<const StabilityRow> rows);
[[nodiscard]] std::string stability_markdown(std::span<const StabilityRow> rows, const std::string& machine);
[[nodiscard]] std::string stability_svg(std::span<const StabilityRow> rows, const std::string& machine);

}  // namespace camopt::stability
