// SPDX-License-Identifier: MIT
// A comparison as people and programs see it: a law a row, sorted by the objective, with its loss, peaks,
// limits and needed base radius; a bar each; all motions over one another (docs/compare.md).
#pragma once

#include "report/document/document.hpp"
#include "report/document/run_origin.hpp"
#include "studies/compare/comparison.hpp"

namespace camopt {

/// Files: comparison.svg, comparison.csv. The scene of a law is that of the comparison with this law as its
/// reference.
[[nodiscard]] Document comparison_document(const Comparison& comparison, const RunOrigin& origin = {});

}  // namespace camopt
