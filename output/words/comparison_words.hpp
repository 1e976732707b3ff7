// SPDX-License-Identifier: MIT
// What the terminal table, the picture and the CSV of a comparison say in the same words. Private to output/.
#pragma once

#include "output/view/number_text.hpp"
#include "studies/compare/comparison.hpp"

namespace camopt {

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

}  // namespace camopt
