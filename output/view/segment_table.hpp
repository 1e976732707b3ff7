// SPDX-License-Identifier: MIT
// The segments of a program as a table for people.
#pragma once

#include "output/view/text_table.hpp"
#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt {

/// Peaks of a segment by its own angle and displacement, `at` in x: a spline's as reported, a law's from the
/// catalogue. None for a dwell.
[[nodiscard]] std::optional<Peaks> segment_peaks(const SegmentReport& segment);

/// "modified trapezoid", "spline", "dwell"
[[nodiscard]] std::string segment_title(const SegmentReport& segment);

/// Kind, angles, displacements, V, A, J, and how smooth the joint at its beginning is: one row a segment.
[[nodiscard]] TextTable segment_table(const Solution& solution);

/// What V, A, J and the joint mean.
[[nodiscard]] const char* segment_table_note();

// Set points beside what the motion makes of them, and a measured motion in a sentence.

/// One row a wanted number, in the unit it was written in. No rows: the scene has none.
[[nodiscard]] TextTable set_point_table(const Solution& solution);

/// "measured.csv: 181 rows as a spline, error at most 0.004 mm (rms 0.001 mm); the optimum's objective is
/// 12 % less than its 1.07". The solution has a measured motion.
[[nodiscard]] std::string measured_sentence(const Solution& solution);

}  // namespace camopt
