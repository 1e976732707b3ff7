// SPDX-License-Identifier: MIT
// The three forms of a design vector before elimination: entries, local maps, built-in rows.
#pragma once

#include "splines/design_vector.hpp"

#include <string>
#include <vector>

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

/// The derivative of `order` at t of the local polynomial, as a row over its columns.
[[nodiscard]] AffineRow functional_of(const LocalMap& map, double t, int order);

/// Replaces fixed entries by their values and renumbers the others.
[[nodiscard]] LocalMap without_fixed(LocalMap map, const DesignForm& form, const std::vector<int>& new_index);
[[nodiscard]] AffineRow without_fixed(const AffineRow& row, const DesignForm& form,
                                      const std::vector<int>& new_index);

}  // namespace camopt
