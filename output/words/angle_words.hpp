// SPDX-License-Identifier: MIT
// Private to output/words: a place of the motion as a person reads it.
#pragma once

#include "core/units.hpp"
#include "output/words/number_text.hpp"
#include "studies/delivered/solution.hpp"

#include <string>

namespace camopt {

inline constexpr int angle_digits = 5;

/// The cam angle of x, degrees, without the unit.
[[nodiscard]] inline std::string degrees_at(const Solution& solution, double x) {
    return short_text(x * solution.scene.motion.unit_angle() / units::degree, angle_digits);
}

}  // namespace camopt
