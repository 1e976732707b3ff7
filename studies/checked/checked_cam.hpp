// SPDX-License-Identifier: MIT
// The forward check of a delivered cam of whatever kind, from its exported points alone.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// By the simulation of its kind: check_cam (studies/check), check_flanks, check_guide. points:
/// about so many, default that of the kind. Throws InputError where the solution has no cam, and where
/// nothing can be checked.
[[nodiscard]] ForwardCheckReport checked_cam(const Solution& solution, std::optional<int> points = {});

/// Puts it into the report of the cam; where it cannot run, a note says why. Nothing to do without a cam.
void add_forward_check(Solution& solution);

}  // namespace camopt
