// SPDX-License-Identifier: MIT
// A comparison for programs: one object a row. What is infinite or absent is null, never NaN; numbers read
// back as the same double. Nothing throws.
#pragma once

#include "output/json/certificate/run_origin.hpp"
#include "studies/compare/comparison.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string comparison_json(const Comparison& comparison, const RunOrigin& origin = {});

}  // namespace camopt
