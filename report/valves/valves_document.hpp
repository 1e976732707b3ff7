// SPDX-License-Identifier: MIT
// Intake and exhaust lobe on one crankshaft for people and programs: overlap, lifts at top dead centre, and
// the clearance between the valves over the crank angle.
#pragma once

#include "report/document/document.hpp"
#include "studies/valve/valve_report.hpp"

namespace camopt {

/// Lengths in the unit of the intake's scene; mm in files. The pair is that of the two lobes.
[[nodiscard]] Document valves_document(const Solution& intake, const Solution& exhaust,
                                       const ValvePair& pair);

}  // namespace camopt
