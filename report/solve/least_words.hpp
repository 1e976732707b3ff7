// SPDX-License-Identifier: MIT
// How far a number went that a scene seeks (studies/least/least_value.hpp), in words.
#pragma once

#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt {

/// "The least pressure angle limit (limits.pressure_angle_deg) is 25.2141 deg: at 25.2128 deg it is proved
/// that no motion exists, together with the velocity limit. The weights choose among the motions at it."
/// Empty where the scene seeks no number or no value was found.
[[nodiscard]] std::string least_sentence(const Solution& solution);

}  // namespace camopt
