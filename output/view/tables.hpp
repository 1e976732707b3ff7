// SPDX-License-Identifier: MIT
// The tables of a solution for people: console, report.md and pages show them. A new table is one row of
// tables.cpp.
#pragma once

#include "output/view/number_text.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// "modified trapezoid", "spline", "dwell"
[[nodiscard]] std::string segment_title(const SegmentReport& segment);

/// Kind, angles, displacements, V, A, J, and how smooth the joint at its beginning is: one row a segment.
[[nodiscard]] TextTable segment_table(const Solution& solution);

/// What V, A, J and the joint mean.
[[nodiscard]] const char* segment_table_note();

struct ViewTable {
    std::string key;    ///< "peaks"
    std::string title;  ///< "Peaks of the motion"
    TextTable table;
    std::string note = {};
};

/// changes, measured, peaks, valve, valve_figures, segments, limits, set_points, surge, dimensions, cam,
/// title_block: those that have rows, in this order.
[[nodiscard]] std::vector<ViewTable> result_tables(const Solution& solution);

/// "natural frequency of the spring 400 Hz, 8 times the speed of the cam (3000 rpm); amplitudes of the
/// harmonics of the lift near it: 12 µm (7), …". The solution has a spring with a natural frequency.
[[nodiscard]] std::string surge_sentence(const Solution& solution);

/// Labels and words of the fields of the title block that are given.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> title_block_words(const Scene& scene);

/// Peaks beside those of the reference and of the best curve of any kind, one row a peak. Of a program those
/// of the whole motion, then the largest over its spline segments.
[[nodiscard]] TextTable peak_table(const Solution& solution);

[[nodiscard]] TextTable limit_table(const Solution& solution);
/// What is allowed: "30 deg".
[[nodiscard]] std::string limit_text(const ConstraintReport& row);
/// "active", "not active", "violated".
[[nodiscard]] const char* standing_words(const Solution& solution, const ConstraintReport& row);
/// "29.8 deg on the outer flank", "undercut, no contact", "nowhere concave".
[[nodiscard]] std::string reached_text(const ConstraintReport& row, int digits = 9);
/// The cam angle of it; "–" where it is nowhere.
[[nodiscard]] std::string reached_degrees(const Solution& solution, const ConstraintReport& row);

/// One row a change of one number alone: key, given, needed.
[[nodiscard]] TextTable relaxation_table(const Solution& solution);

// Set points beside what the motion makes of them, and a measured motion in a sentence.

/// One row a wanted number, in the unit it was written in. No rows: the scene has none.
[[nodiscard]] TextTable set_point_table(const Solution& solution);

/// Fewer than twice as many rows as free numbers of the fit.
[[nodiscard]] bool follows_noise(const MeasuredReport& measured);
/// How much less than that of the measured motion the optimum's objective is, in percent of it; none where
/// there is nothing to compare: of noise, or of the very motion that is sought, none is better.
[[nodiscard]] std::optional<double> gain_percent(const Solution& solution);

/// "measured.csv: 181 rows as a spline, error at most 0.004 mm (rms 0.001 mm); the optimum's objective is
/// 12 % less than its 1.07". The solution has a measured motion.
[[nodiscard]] std::string measured_sentence(const Solution& solution);

}  // namespace camopt
