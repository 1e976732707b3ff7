// SPDX-License-Identifier: MIT
// Sweeps, papers, comparisons and plans for people.
#pragma once

#include "output/view/number_text.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/papers/paper_report.hpp"
#include "studies/search/plan.hpp"
#include "studies/sweep/sweep_row.hpp"

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

// A comparison for a terminal: one line a law, sorted by the objective. Infinite is "∞". Nothing throws.
[[nodiscard]] std::string comparison_text(const Comparison& comparison);

// What the terminal table, the picture and the CSV of a comparison say in the same words. Private to output/.

/// "optimum", or the law's title.
[[nodiscard]] std::string row_title(const ComparisonRow& row);

/// "+6.43 %"; "–" where there is none.
[[nodiscard]] std::string loss_words(const ComparisonRow& row);

/// "pressure angle 36.2 deg, 6.2 above 30".
[[nodiscard]] std::string broken_words(const LimitOutcome& outcome);

/// One entry a violated limit, the heaviest (by the scale of the limit) first.
[[nodiscard]] std::vector<std::string> broken_limits(const ComparisonRow& row);

/// "base mm" or "base in", and the radius in it; "none" where none helps; empty where the scene limits no
/// cam.
[[nodiscard]] std::string base_title(const Comparison& comparison);
[[nodiscard]] std::string base_words(const Comparison& comparison, const ComparisonRow& row);

/// The peaks of velocity, acceleration and jerk as a person reads them, where the scene has a speed; empty
/// without one: then V, A, J say it all.
struct PhysicalPeak {
    std::string title;  ///< "v mm/s"
    std::function<double(const ComparisonRow&)> value;
    int decimals = 0;  ///< of all rows: four figures of the largest

    [[nodiscard]] std::string text(const ComparisonRow& row) const {
        return fixed_text(value(row), decimals);
    }
};
[[nodiscard]] std::vector<PhysicalPeak> physical_peaks(const Comparison& comparison);

/// Whether any row has something to say of a base radius.
[[nodiscard]] bool has_bases(const Comparison& comparison);

/// The best law that satisfies every limit; null where none does.
[[nodiscard]] const ComparisonRow* best_law(const Comparison& comparison);

/// One or two sentences: what the laws lose at least, or that none satisfies every limit.
[[nodiscard]] std::string comparison_sentence(const Comparison& comparison);

/// "0.4 V/1.76 + 0.4 A/5.528 + 0.2 J/69.47".
[[nodiscard]] std::string objective_words(const Comparison& comparison);

// The plan of a solve in words, for `camopt check`.

/// One line each: "Searched: …", "Solved: by …", …; what the plan does not contain is left out.
[[nodiscard]] std::vector<std::string> plan_lines(const SolvePlan& plan);

}  // namespace camopt
