// SPDX-License-Identifier: MIT
// The three forms of a design vector before elimination: entries, local maps, built-in rows.
#pragma once

#include "splines/design_request.hpp"

namespace camopt {

struct DesignEntry {
    std::string name;
    int order = 0;
    int place = 0;  ///< breakpoint, or basis function for coefficients
    bool fixed = false;
    double value = 0.0;  ///< where fixed
};

struct DesignForm {
    std::vector<DesignEntry> entries;
    std::vector<LocalMap> maps;            ///< one per segment, columns count all entries
    std::vector<Equality> rows;            ///< continuity and symmetry: independent by construction
    std::vector<PointCondition> leftover;  ///< end states not built into the form
    /// Every entry affects every segment: next to a narrow one the weights of the others are small, but their
    /// entries are not.
    bool dense = false;
};

/// Dispatches on request.kind.
[[nodiscard]] DesignForm raw_form(const DesignRequest& request);

/// Replaces fixed entries by their values and renumbers the others.
[[nodiscard]] LocalMap without_fixed(LocalMap map, const DesignForm& form, const std::vector<int>& new_index);
[[nodiscard]] AffineRow without_fixed(const AffineRow& row, const DesignForm& form,
                                      const std::vector<int>& new_index);

// Which exact points of a request are compatible, redundant or contradictory.
//
// The rank is determined for the control points, where continuity and the end states are built in: then only
// symmetry and the points are rows, and the result holds for every form of the design vector.

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
/// The slope is known to round-off over d: its uncertainty.
[[nodiscard]] Equality unlike(Equality condition, const std::vector<AffineRow>& others);

}  // namespace camopt
