// SPDX-License-Identifier: MIT
// Every row of the stability table, by group.
#pragma once

#include "tests/soak/stability/stability_row.hpp"

namespace camopt::stability {

/// Condition numbers and attained accuracy of the three design vectors.
[[nodiscard]] std::vector<StabilityCase> design_vector_cases();
/// Many segments, against the optima of a rival's linear programs.
[[nodiscard]] std::vector<StabilityCase> many_segment_cases();
/// Lengths, angles and speeds times 1e±9: the normalised result stays.
[[nodiscard]] std::vector<StabilityCase> scaling_cases();
/// Weights at the corners of the simplex, 1e-12 beside them, all times 1e±9.
[[nodiscard]] std::vector<StabilityCase> weight_cases();
/// Breakpoints whose distances differ by 1e8.
[[nodiscard]] std::vector<StabilityCase> breakpoint_cases();
/// Exact points that follow from others, nearly or exactly.
[[nodiscard]] std::vector<StabilityCase> exact_point_cases();
/// Limits within 1e-9 of impossible, from both sides.
[[nodiscard]] std::vector<StabilityCase> limit_cases();
/// Optima that are not unique, not attained, or the only motion there is.
[[nodiscard]] std::vector<StabilityCase> degenerate_cases();
/// What README.md, docs/ and benchmarks/README.md say about accuracy.
[[nodiscard]] std::vector<StabilityCase> claim_cases();
/// Of these about finished cams: the forward check, the polyline of profile.csv, sampled peaks.
[[nodiscard]] std::vector<StabilityCase> profile_claims();
/// Of these about remote, barrel, cylindrical and inverse cams: drawings, forward checks, optima.
[[nodiscard]] std::vector<StabilityCase> mechanism_claims();
[[nodiscard]] std::vector<StabilityCase> train_cases();

[[nodiscard]] std::vector<StabilityCase> all_cases();

}  // namespace camopt::stability
