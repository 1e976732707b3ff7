// SPDX-License-Identifier: MIT
// T.-Y. Shon and M.-Y. Yang, "Synthesis of Optimum CAM Curve by Cubic Spline", 1994: Tables 1 to 4 and Figs.
// 1 to 8 beside the proved optima. The numbers are those of studies/compare/reference_table.hpp.
#pragma once

#include "studies/compare/reference_table.hpp"
#include "studies/papers/paper_catalogue.hpp"

namespace camopt {

/// Some seconds: 15 solves.
[[nodiscard]] PaperReport paper_004(const SolveControl& control = {}, const PaperProgress& finished = {});

/// The report of a table that is already computed.
[[nodiscard]] PaperReport paper_004_report(const ReferenceTable& table);

}  // namespace camopt
