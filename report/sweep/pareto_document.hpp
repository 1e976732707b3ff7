// SPDX-License-Identifier: MIT
// A front of two goals as people and programs see it: its points, the picture, the scene of each solve.
#pragma once

#include "report/chart/studies/pareto_svg.hpp"
#include "report/document/document.hpp"

namespace camopt {

/// Files: pareto.svg, pareto.csv (docs/sweep.md). The scene of a point minimizes what its solve did, with its
/// cap as a limit.
[[nodiscard]] Document pareto_document(const ParetoPicture& picture, const std::string& title);

}  // namespace camopt
