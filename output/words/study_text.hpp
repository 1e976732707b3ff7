// SPDX-License-Identifier: MIT
// Sweeps for people.
#pragma once

#include "studies/sweep/sweep_row.hpp"

namespace camopt {

/// A finished sweep in a few lines: rows by verdict, the front where one is marked, the row of the least
/// objective, the seconds its solves took; failed rows with their reasons. Each line indented by two spaces.
/// scene: that of any row, to name the peaks of the best row in time where it has a speed; null: they are not
/// named.
[[nodiscard]] std::string sweep_text(const SweepTable& table, const Scene* scene = nullptr);

}  // namespace camopt
