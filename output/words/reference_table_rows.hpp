// SPDX-License-Identifier: MIT
// The reference table's values as cells: what the terminal text and the Markdown page share. Private to
// output/.
#pragma once

#include "output/view/text_table.hpp"
#include "studies/papers/reference_table.hpp"

#include <optional>
#include <string>
#include <vector>

namespace camopt {

struct TableSection {
    std::string title;
    std::string introduction;
    TextTable table;
};

/// Convergence, points, laws, weights, in this order.
[[nodiscard]] std::vector<TableSection> reference_table_sections(const ReferenceTable& table);

/// Peaks and objective of the delivered curve; none where a solve gave no curve.
[[nodiscard]] std::optional<PeakFigures> optimum_figures(const Solution& solution);

/// "optimal" with its gap, or in capitals what it is instead and why.
[[nodiscard]] std::string verdict_text(const Certificate& certificate);

/// The solves that are not proved optimal, in words: "n = 10 (failed: time_limit)".
[[nodiscard]] std::vector<std::string> unproved_rows(const ReferenceTable& table);

/// One sentence naming them; empty where every row is proved.
[[nodiscard]] std::string unproved_warning(const ReferenceTable& table);

}  // namespace camopt
