// SPDX-License-Identifier: MIT
// What a reader makes of table.csv: how far straight lines between its rows are from the motion.
#pragma once

#include "report/csv/motion_csv.hpp"

namespace camopt {

/// Over the whole table, not at samples: for a column that is y⁽ʳ⁾ of the motion (r = 0 … 3) in some unit
///
///     max |value(θ) − motion⁽ʳ⁾(θ)|,  value linear in θ between the printed rows,
///
/// bounded from above as the losses of an electronic cam are (cam_pieces.hpp). Where a derivative jumps
/// between two rows the bound is at least half of the jump. Other columns are named.
struct TableCheck {
    std::string json;   ///< table.check.json (docs/results.md)
    std::string words;  ///< "straight lines between the rows: s_mm 1.2e-3, …"; empty: nothing to say
};

/// Throws InputError where the solution has no motion.
[[nodiscard]] TableCheck table_check(const Solution& solution, const UniformTable& table);

}  // namespace camopt
