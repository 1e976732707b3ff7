// SPDX-License-Identifier: MIT
// A front of two goals as people see it: its points, the picture, the scene of each solve. Its rows are in
// pareto.csv.
#pragma once

#include "report/chart/studies/pareto_svg.hpp"
#include "report/document/document.hpp"
#include "report/json/sweep_json.hpp"

namespace camopt {

/// The scene of a point minimizes what its solve did, with its cap as a limit.
[[nodiscard]] Document pareto_document(const ParetoPicture& picture, const SweepIdentity& identity);

}  // namespace camopt
