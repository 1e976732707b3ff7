// SPDX-License-Identifier: MIT
// A comparison for a terminal: one line a law, sorted by the objective. Infinite is "∞". Nothing throws.
#pragma once

#include "studies/compare/comparison.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string comparison_text(const Comparison& comparison);

}  // namespace camopt
