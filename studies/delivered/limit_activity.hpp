// SPDX-License-Identifier: MIT
// The size of the quantity that a limit holds, and with it when a limit is active. The only place that judges
// either: reports, audit and comparison ask here.
//
//     active:  slack <= active_limit · scale,   slack = reached − limit of a least value, limit − reached
//     else
//
// The scale comes from the quantity and not from the limit, which may be 0: of a radius of the cam its base
// radius, of an undercut margin 1, of a force on the cam the largest one that the motion reaches, of the
// force of an elastic train its springs at the lift; of everything else, whose limit is above 0, the larger
// of limit and reached value. A radius that the cam has nowhere is infinite: its limit is not active.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// Of the scale. Solved limits are met to the tolerance of the solve, 1e-9 by default; what the tie-break
/// leaves of an active limit is below 1e-6.
inline constexpr double active_limit = 1e-6;

/// In the unit of the report. `cam`: of the scene; null where there is none.
[[nodiscard]] double limit_scale(const Scene& scene, const CamReport* cam, const ConstraintReport& report);

/// How far the limit is passed, in the unit of the report; below 0 where it is satisfied.
[[nodiscard]] double limit_excess(const ConstraintReport& report);

/// A radius that the cam has nowhere: the limit is satisfied, there is no value and no cam angle.
[[nodiscard]] bool is_nowhere(const ConstraintReport& report);

/// Sets `active` of every constraint of a solution with its motion, cam and train.
void judge_activity(Solution& solution);

}  // namespace camopt
