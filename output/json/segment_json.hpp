// SPDX-License-Identifier: MIT
// Splines, peaks and the segments of a program in result.json. Private to output/.
#pragma once

#include "output/json/json_text.hpp"
#include "studies/delivered/solution.hpp"

#include <optional>

namespace camopt {

/// Breakpoints, knots and control points over x; null where there is none.
[[nodiscard]] Json spline_json(const std::optional<SplineCurve>& curve);

[[nodiscard]] Json peaks_json(const std::optional<Peaks>& peaks);

/// One entry a segment; null for a motion that is no program, and where there is no motion.
[[nodiscard]] Json segments_json(const Solution& solution);

}  // namespace camopt
