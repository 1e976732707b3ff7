// SPDX-License-Identifier: MIT
// Conditions on the motion that cannot be met together: infeasible before anything is solved.
#pragma once

#include "splines/motion_family.hpp"
#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt {

/// Sets verdict, proof and notes of a family that has contradictions.
void report_contradictions(Solution& solution, const MotionFamily& family);

/// "a; b; c": what a condition follows from or fights with.
[[nodiscard]] std::string list_of(const ConditionConflict& conflict);

}  // namespace camopt
