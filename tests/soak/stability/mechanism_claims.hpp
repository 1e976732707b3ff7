// SPDX-License-Identifier: MIT
// What the manual says about remote, barrel, cylindrical and inverse cams: drawings, forward checks, optima.
#pragma once

#include "tests/soak/stability/stability_row.hpp"

namespace camopt::stability {

[[nodiscard]] std::vector<StabilityCase> mechanism_claims();

}  // namespace camopt::stability
