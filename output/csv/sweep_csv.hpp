// SPDX-License-Identifier: MIT
// sweep.csv: one line a row of the sweep, by number.
//
// Columns: row, the varied keys as written, verdict, reason, pareto_front (1 or 0), objective, lower_bound,
// gap, any_curve_limit, the figures (normalised), the variable dimensions in mm, active_limits (keys, joined
// by "; "), counts, seconds_solve, seconds_total. Numbers read back as the same double; what does not exist
// is an empty cell. docs/sweep.md explains each.
#pragma once

#include "studies/sweep/sweep_row.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace camopt {

/// The first line.
[[nodiscard]] std::vector<std::string> sweep_csv_columns(const SweepColumns& columns);

[[nodiscard]] std::string sweep_csv(const SweepTable& table);

/// The table of such a text; SweepColumns::criteria does not stand in it and is left empty. Throws InputError
/// "NAME:LINE: …" for anything that sweep_csv would not have written.
[[nodiscard]] SweepTable read_sweep_csv(std::string_view text, std::string_view name);

}  // namespace camopt
