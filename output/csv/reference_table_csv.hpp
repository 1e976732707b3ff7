// SPDX-License-Identifier: MIT
// The reference table for spreadsheets: one CSV text a table.
//
// First line the column names. Numbers read back as the same double; what is infinite or absent is an empty
// cell. Peaks are normalised, without units. Nothing throws.
#pragma once

#include "studies/compare/reference_table.hpp"

#include <string>

namespace camopt {

/// segments, i, x, the paper's y_i, the optimum's.
[[nodiscard]] std::string optimum_points_csv(const ReferenceTable& table);

/// One row a number of segments: printed, the printed points evaluated, misprint corrected, optimum and
/// proof.
[[nodiscard]] std::string convergence_csv(const ReferenceTable& table);

/// One row a classical law.
[[nodiscard]] std::string laws_csv(const ReferenceTable& table);

/// One row a weighting, n = 10.
[[nodiscard]] std::string weights_csv(const ReferenceTable& table);

}  // namespace camopt
