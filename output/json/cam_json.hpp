// SPDX-License-Identifier: MIT
// The entries of result.json that only a scene with a cam has. Private to output/.
#pragma once

#include "output/json/json_text.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// {"base_radius_mm": 40.0, …, "prime_radius_mm": 50.0}, {"lever_angle_deg": -10.0, …}; empty without a cam,
/// null for what is free and was not delivered.
[[nodiscard]] Json dimensions_json(const Solution& solution);

/// The figures of the delivered cam; null where there is none.
[[nodiscard]] Json cam_json(const Solution& solution);

}  // namespace camopt
