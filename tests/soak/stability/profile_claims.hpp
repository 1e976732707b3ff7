// SPDX-License-Identifier: MIT
// What the manual says about finished cams: the forward check, the polyline of profile.csv, sampled peaks.
#pragma once

#include "tests/soak/stability/stability_row.hpp"

namespace camopt::stability {

[[nodiscard]] std::vector<StabilityCase> profile_claims();

}  // namespace camopt::stability
