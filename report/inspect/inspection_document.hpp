// SPDX-License-Identifier: MIT
// An inspection for people and programs: deviations in µm, of displacements that are angles in mdeg.
#pragma once

#include "report/document/document.hpp"
#include "studies/inspect/inspection.hpp"

namespace camopt {

/// title: what was compared with what. The table of the rows is inspection.csv.
[[nodiscard]] Document inspection_document(const Inspection& found, const std::string& title);

}  // namespace camopt
