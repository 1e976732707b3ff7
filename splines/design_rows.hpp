// SPDX-License-Identifier: MIT
// Which exact points of a request can be kept together, which follow from the others, and which contradict
// them.
//
// The question is asked of the control points, where continuity and the end states are built in: then only
// symmetry and the points themselves are rows, and the answer holds for every form of the design vector.
#pragma once

#include "splines/design_forms.hpp"

#include <vector>

namespace camopt {

struct ConditionSelection {
    std::vector<PointCondition> kept;  ///< independent of each other, of the ends and of symmetry
    std::vector<ConditionConflict> redundant, contradictions;
};

/// A redundant condition counts as a finding only where the user asked for it.
[[nodiscard]] ConditionSelection select_conditions(const DesignRequest& request);

/// The condition as a row over the entries that are not fixed: weights · x + offset = 0. A weight that is
/// nothing beside the largest of the row, fixed entries counted, is rounding and left out: where only such
/// ones are left the fixed entries decide alone whether the condition holds.
[[nodiscard]] AffineRow condition_row(const DesignForm& form, const SplineSpace& space,
                                      const PointCondition& condition, const std::vector<int>& new_index);

/// The same condition, given that the others hold, as a row that is not nearly parallel to any of them: two
/// points d apart become a point and a slope, so that the rows' condition does not grow like 1/d.
[[nodiscard]] AffineRow unlike(AffineRow row, const std::vector<AffineRow>& others);

}  // namespace camopt
