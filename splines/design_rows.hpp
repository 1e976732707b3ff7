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

/// The same condition, given that the others hold, as a row that is not nearly parallel to any of them: two
/// points d apart become a point and a slope, so that the rows' condition does not grow like 1/d.
[[nodiscard]] AffineRow unlike(AffineRow row, const std::vector<AffineRow>& others);

}  // namespace camopt
