// SPDX-License-Identifier: MIT
// A solution made by hand: the best cubic spline of four segments, known in closed form.
//   y''' = 32, −32, −32, 32:  V = 2 at x = 1/2, A = 8 at x = 1/4, J = 32.
#pragma once

#include "studies/solution.hpp"

namespace camopt::test {

/// DRD, lift 10 mm, rise 90 deg, 300 rpm, references 1.76, 5.53, 69, proof of two rows.
[[nodiscard]] Solution sample_solution();

/// The same scene with a cap that cannot be kept: no curve, a relaxation.
[[nodiscard]] Solution infeasible_solution();

}  // namespace camopt::test
