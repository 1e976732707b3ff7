// SPDX-License-Identifier: MIT
// Studies beside a solve as JSON: elastic follower trains, comparisons.
#pragma once

#include "output/json/result_json.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/response/train_study.hpp"

namespace camopt {

// What an elastic follower train makes of motions.

/// {"rows": [{"motion", "speed_rpm", "frequency_ratio", "residual", "peak_deflection", "peak_acceleration",
/// "lifts_off", …}], …}
[[nodiscard]] std::string dynamics_json(const TrainStudy& study);

// A comparison for programs: one object a row. What is infinite or absent is null, never NaN; numbers read
// back as the same double. Nothing throws.
[[nodiscard]] std::string comparison_json(const Comparison& comparison, const RunOrigin& origin = {});

}  // namespace camopt
