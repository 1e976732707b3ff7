// SPDX-License-Identifier: MIT
// Whether a delivered motion meets what its scene demands exactly: its ends and joints, the top of a rise and
// return, displacements of a program, exact points, symmetry, ends without jerk. From the motion alone,
// whatever the optimizer built in or eliminated.
#pragma once

#include "studies/delivered/solution.hpp"

#include <string>
#include <vector>

namespace camopt {

/// A condition, and by how much the motion misses it.
struct ConditionMiss {
    std::string condition;  ///< in words: "y' = 1 at x = 0.5 (motion.via[0].velocity)"
    double relative = 0.0;  ///< by the larger of the wanted value and the derivative's peak (y: of 1)
    double at = 0.0;        ///< x
};

/// Those that are missed by more than `tolerance`, the worst first. Nothing where no motion was delivered.
[[nodiscard]] std::vector<ConditionMiss> missed_conditions(const Solution& solution, double tolerance);

}  // namespace camopt
