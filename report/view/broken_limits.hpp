// SPDX-License-Identifier: MIT
// The limits that a law violates. Private to report/.
#pragma once

#include "report/view/number_text.hpp"
#include "studies/compare/comparison.hpp"

namespace camopt {

/// "pressure angle 36.2 deg, 6.2 above 30": one entry a violated limit, the heaviest (by the scale of the
/// limit) first.
[[nodiscard]] std::vector<std::string> broken_limits(const ComparisonRow& row);

}  // namespace camopt
