// SPDX-License-Identifier: MIT
// The plan of a solve in words, for `camopt check`.
#pragma once

#include "studies/search/plan.hpp"

namespace camopt {

/// One line each: "Searched: …", "Solved: by …", …; what the plan does not contain is left out.
[[nodiscard]] std::vector<std::string> plan_lines(const SolvePlan& plan);

}  // namespace camopt
