// SPDX-License-Identifier: MIT
// The limits of a delivered motion, held against every cam within the tolerances of its scene
// (objectives/rules/made_cams.hpp): figures are those of the motion and the cam with their errors.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// Sets ConstraintReport::made of every limit of the cam and of the motion. The scene has tolerances.
void hold_for_made_cams(Solution& solution);

/// The limits of the cam, of each the worst over all cams within the tolerances of `scene`: that of the
/// solution, perhaps with other tolerances. The solution has a cam.
[[nodiscard]] std::vector<ConstraintReport> made_constraints(const Solution& solution, const Scene& scene);

/// Cams between the ends of the tolerances that pass a limit of the solution, to a thousandth of a tolerance;
/// without those of ToleranceSpec::between.
[[nodiscard]] std::vector<MadeParts> passing_cams(const Solution& solution);

}  // namespace camopt
