// SPDX-License-Identifier: MIT
// Which of the rows E x = e of a design vector are kept, which follow from them, and which contradict them.
#pragma once

#include "splines/design_forms.hpp"

#include <vector>

namespace camopt {

struct RowSelection {
    std::vector<Equality> rows;  ///< independent
    std::vector<ConditionConflict> redundant, contradictions;
    std::vector<int> fixed_entries;  ///< entries that a row fixes by itself
};

/// `size`: entries of the design vector. A redundant row counts as a finding only where an exact point is
/// part of it.
[[nodiscard]] RowSelection independent_rows(std::vector<CandidateRow> candidates, int size);

}  // namespace camopt
