// SPDX-License-Identifier: MIT
// Sweeps, papers and the reference table for people.
#pragma once

#include "scene/scene.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/papers/paper_report.hpp"
#include "studies/papers/reference_table.hpp"
#include "studies/sweep/sweep_row.hpp"

#include <string>

namespace camopt {

/// A finished sweep in a few lines: rows by verdict, the front where one is marked, the row of the least
/// objective, the seconds its solves took; failed rows with their reasons. Each line indented by two spaces.
/// scene: that of any row, to name the peaks of the best row in time where it has a speed; null: they are not
/// named.
[[nodiscard]] std::string sweep_text(const SweepTable& table, const Scene* scene = nullptr);

// A paper's report for people: on the terminal, or as a Markdown page. Figures are named by their titles;
// their pictures are study_svg.hpp.
[[nodiscard]] std::string paper_report_text(const PaperReport& report);

/// Names the figures' files: <key>.svg beside the page.
[[nodiscard]] std::string paper_report_markdown(const PaperReport& report);

// The reference table for people: plain text for a terminal, and the same as a Markdown page.
//
// Peaks and objective are normalised, without units. A solve that is not proved optimal is said to be so in
// its own row and once more at the top. An infinite jerk is "∞". Nothing throws.
[[nodiscard]] std::string reference_table_text(const ReferenceTable& table);

[[nodiscard]] std::string reference_table_markdown(const ReferenceTable& table);

// A comparison for a terminal: one line a law, sorted by the objective. Infinite is "∞". Nothing throws.
[[nodiscard]] std::string comparison_text(const Comparison& comparison);

}  // namespace camopt
