// SPDX-License-Identifier: MIT
// The tables of a solution, and what is said of a measured motion and a spring. A new table is one function
// and its place in solution_document.cpp.
#pragma once

#include "report/document/document.hpp"

namespace camopt {

/// One row a change of one number alone: key, given, needed.
[[nodiscard]] Table change_table(const Solution& solution);

/// The fit of a measured motion; without rows where there is none.
[[nodiscard]] Table measured_table(const Solution& solution);

/// Peaks beside those of the reference and of the best curve of any kind, one row a peak. Of a program those
/// of the whole motion, then the largest over its spline segments.
[[nodiscard]] Table peak_table(const Solution& solution);

/// Kind, angles, displacements, V, A, J, and how smooth the joint at its beginning is: one row a segment.
[[nodiscard]] Table segment_table(const Solution& solution);

/// What is allowed, what is reached and where: one row a limit.
[[nodiscard]] Table limit_table(const Solution& solution);
/// The limits that are active, for who reads nothing else.
[[nodiscard]] std::string active_sentence(const Solution& solution);

/// Set points beside what the motion makes of them: one row a wanted number, in the unit it was written in.
[[nodiscard]] Table set_point_table(const Solution& solution);

/// Harmonics of the lift; without rows where no spring has a natural frequency.
[[nodiscard]] Table surge_table(const Solution& solution);

/// The dimensions of a cam and whether they are given, chosen or follow; its figures; the fields of the title
/// block that are given. For a solution with a cam.
[[nodiscard]] std::vector<Table> cam_tables(const Solution& solution);

/// Labels and words of the fields of the title block that are given.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> title_block_words(const Scene& scene);

/// Names and values of the design vector, exact.
[[nodiscard]] Table design_table(const DesignReport& design);

/// "natural frequency of the spring 400 Hz, 8 times the speed of the cam (3000 rpm); amplitudes of the
/// harmonics of the lift near it: 12 µm (7), …". The solution has a spring with a natural frequency.
[[nodiscard]] std::string surge_sentence(const Solution& solution);

/// "measured.csv: 181 rows as a spline, error at most 0.004 mm (rms 0.001 mm); the optimum's objective is
/// 12 % less than its 1.07". The solution has a measured motion.
[[nodiscard]] std::string measured_sentence(const Solution& solution);

}  // namespace camopt
