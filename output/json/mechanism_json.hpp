// SPDX-License-Identifier: MIT
// The entries of result.json that only a scene with a mechanism beside the disk cam has. Private to output/.
#pragma once

#include "output/json/json_text.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

/// {"roller_radius_mm": 30.0, …, "lever_angle_deg": -10.0}; null for what is free and was not delivered.
[[nodiscard]] Json mechanism_dimensions_json(const Solution& solution);

/// The figures of the delivered cam; null where there is none.
[[nodiscard]] Json mechanism_json(const Solution& solution);

}  // namespace camopt
