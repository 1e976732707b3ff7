// SPDX-License-Identifier: MIT
// Which exact points of a request are compatible, redundant or contradictory.
//
// The rank is determined for the control points, where continuity and the end states are built in: then only
// symmetry and the points are rows, and the result holds for every form of the design vector.
#pragma once

#include "splines/design_forms.hpp"

#include <vector>

namespace camopt {

struct ConditionSelection {
    std::vector<PointCondition> kept;  ///< independent of each other, of the ends and of symmetry
    std::vector<ConditionConflict> redundant, contradictions;
};

/// A redundant condition is reported only if the user requested it.
[[nodiscard]] ConditionSelection select_conditions(const DesignRequest& request);

/// The condition as a row over the free entries: weights · x + offset = 0. A weight that is negligible
/// relative to the largest of the row, fixed entries included, is round-off and omitted: if only such weights
/// remain, the fixed entries alone decide whether the condition holds.
[[nodiscard]] AffineRow condition_row(const DesignForm& form, const SplineSpace& space,
                                      const PointCondition& condition, const std::vector<int>& new_index);

/// The same condition, given that the others hold, as a row that is not nearly parallel to any of them: two
/// points at a distance d become a point and a slope, so that the condition number does not grow like 1/d.
[[nodiscard]] AffineRow unlike(AffineRow row, const std::vector<AffineRow>& others);

}  // namespace camopt
