// SPDX-License-Identifier: MIT
// A valve lobe, for people and for result.json.
#pragma once

#include "report/document/document.hpp"
#include "studies/valve/valve_report.hpp"

namespace camopt {

/// "valve": events, durations and areas by lift. "valve_figures": lobe lift, velocities, accelerations,
/// radii, force over engine speed. Empty for a motion of another type.
[[nodiscard]] std::vector<Table> valve_tables(const Solution& solution);

/// Lobe lift, velocities, accelerations, radii; the events of the valve, a row a lift.
[[nodiscard]] std::vector<Figure> valve_figures(const Solution& solution, const ValveReport& report);
[[nodiscard]] Table valve_events(const Solution& solution, const ValveReport& report);

/// "16.3 BTDC", "52 ABDC": a crank angle (rad) by the nearest dead centre; 0 is the top one.
[[nodiscard]] std::string dead_centre_text(double crank);

}  // namespace camopt
