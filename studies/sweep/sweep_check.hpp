// SPDX-License-Identifier: MIT
// Every row of a sweep looked at before anything is solved.
#pragma once

#include "studies/sweep/sweep_plan.hpp"
#include "studies/sweep/sweep_row.hpp"

namespace camopt {

/// Makes the scene of every row and checks what solve() would refuse. Throws InputError naming the first row
/// that is wrong, its values and why; UnavailableError for a backend this build leaves out. Returns what the
/// rows have in common.
[[nodiscard]] SweepColumns check_rows(SweepScenes& scenes);

}  // namespace camopt
