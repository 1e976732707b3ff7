// SPDX-License-Identifier: MIT
// A valve lobe for people.
#pragma once

#include "output/view/tables.hpp"
#include "studies/valve/valve_report.hpp"

namespace camopt {

/// "valve": events, durations and areas by lift. "valve_figures": lobe lift, velocities, accelerations,
/// radii, force over engine speed. Empty for a motion of another type.
[[nodiscard]] std::vector<ViewTable> valve_tables(const Solution& solution);

/// "16.3 BTDC", "52 ABDC": a crank angle (rad) by the nearest dead centre; 0 is the top one.
[[nodiscard]] std::string dead_centre_text(double crank);

}  // namespace camopt
