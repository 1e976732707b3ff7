// SPDX-License-Identifier: MIT
// Lengths and angles in messages: six significant digits and the unit.
#pragma once

#include "core/units.hpp"

#include <string>
#include <string_view>

namespace camopt {

/// m → "12.5 mm", "0.5 in".
[[nodiscard]] std::string length_text(double length, LengthUnit unit = LengthUnit::millimetre);

/// rad → "30 deg".
[[nodiscard]] std::string angle_text(double angle);

/// "the base_radius of -3 mm is not positive"; empty: it may be so. `has_sign`: 0 and negative ones may.
[[nodiscard]] std::string length_fault(std::string_view name, double length, bool has_sign);

/// What a lift is.
[[nodiscard]] constexpr const char* length_or_angle(bool is_angle) {
    return is_angle ? "an angle" : "a length";
}

}  // namespace camopt
