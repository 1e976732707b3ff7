// SPDX-License-Identifier: MIT
// Private to studies/papers/: the parts of the report on paper 000, one source each.
#pragma once

#include "studies/papers/paper_000_data.hpp"
#include "studies/papers/paper_catalogue.hpp"

#include <vector>

namespace camopt::feeding_paper {

/// Table 1 beside ours, its misprints, the counts, the recovered dimensions (paper_000_tables.cpp).
[[nodiscard]] std::vector<PaperTable> printed_tables();

/// Figs. 9 and 10, the guides, the machine (paper_000_figures.cpp).
[[nodiscard]] std::vector<PaperFigure> printed_figures();

/// The approximate method against the number of nodes, forward simulations (paper_000_checks.cpp).
void add_checks(PaperReport& report);

/// The best guide beside lines and arcs (paper_000_guides.cpp). Adds a fault where an optimum is not proved.
void add_guides(PaperReport& report, const SolveControl& control, const PaperProgress& finished);

}  // namespace camopt::feeding_paper
