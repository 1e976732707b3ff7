// SPDX-License-Identifier: MIT
// Set points beside what the motion makes of them, and a measured motion in a sentence.
#pragma once

#include "output/words/tables/text_table.hpp"
#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt {

/// One row a wanted number, in the unit it was written in. No rows: the scene has none.
[[nodiscard]] TextTable set_point_table(const Solution& solution);

/// "measured.csv: 181 rows as a spline, error at most 0.004 mm (rms 0.001 mm); the optimum's objective is
/// 12 % less than its 1.07". The solution has a measured motion.
[[nodiscard]] std::string measured_sentence(const Solution& solution);

}  // namespace camopt
