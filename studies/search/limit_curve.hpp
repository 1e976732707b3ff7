// SPDX-License-Identifier: MIT
// The limit that no curve can pass, for the objective of a scene (motions/bounds/any_curve_limit.hpp).
#pragma once

#include "studies/delivered/solution.hpp"

#include <optional>

namespace camopt {

/// reference: what the peaks are divided by. None for programs, and where the objective holds more than
/// peaks. Some milliseconds.
[[nodiscard]] std::optional<LimitCurve> limit_curve(const Scene& scene, const Peaks& reference);

}  // namespace camopt
