// SPDX-License-Identifier: MIT
// The segments of a program as a table for people.
#pragma once

#include "output/words/tables/text_table.hpp"
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

}  // namespace camopt
