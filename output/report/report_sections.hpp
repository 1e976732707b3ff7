// SPDX-License-Identifier: MIT
// Sections of report.md that not every result has. Empty where they have nothing to say.
#pragma once

#include "output/json/certificate/run_origin.hpp"
#include "output/words/tables/peak_comparison.hpp"
#include "output/words/tables/text_table.hpp"
#include "studies/delivered/solution.hpp"

#include <functional>
#include <string>
#include <vector>

namespace camopt {

/// "The cam": dimensions, figures, remarks, pictures.
[[nodiscard]] std::string cam_section(const Solution& solution);

/// "Peaks" of a program: normalised ones of the spline segments, physical ones of the whole motion.
[[nodiscard]] std::string program_peak_section(const Solution& solution);

/// The peaks of a scene's motion, one a row, with further columns behind: their titles, and their cells.
[[nodiscard]] TextTable peak_rows(const Solution& solution, const std::string& first_title,
                                  const std::vector<std::string>& titles,
                                  const std::function<std::vector<std::string>(const PeakRow&)>& cells);

/// "Segments": the table of a program.
[[nodiscard]] std::string segment_section(const Solution& solution);

/// "Why this spline has no motion, and what would have to change", in words; "no motion exists" where that is
/// known.
[[nodiscard]] std::string infeasible_section(const Solution& solution);

/// "The scene, key by key" and the scene file itself: the report alone repeats the run. Empty where the
/// origin has no text.
[[nodiscard]] std::string scene_section(const RunOrigin& origin);

}  // namespace camopt
