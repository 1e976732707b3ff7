// SPDX-License-Identifier: MIT
// A comparison as a picture: one bar a law, sorted by the objective, with its peaks and its loss.
//
// Solid bars keep every limit; hatched ones break some, and the heaviest is named. Bars far longer than the
// optimum's are cut. Nothing throws.
#pragma once

#include "studies/compare/comparison.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string comparison_svg(const Comparison& comparison);

}  // namespace camopt
