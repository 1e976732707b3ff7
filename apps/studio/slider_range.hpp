// SPDX-License-Identifier: MIT
// How far a slider goes and how fine: within what a key allows, around where its value stands.
#pragma once

#include "core/numbers/range.hpp"

namespace camopt::apps {

struct SliderRange {
    double from = 0.0, to = 1.0, step = 0.01;
};

/// The whole range where it has two ends. Else from its one end, or from zero (a negative value: from as far
/// on the other side), to twice the value, rounded up to 1, 2 or 5 times a power of ten; of 0 to 1. The step,
/// 1, 2 or 5 times a power of ten, is a two-hundredth of the way or less; 1 of integers. An end that is not
/// allowed itself is left out by one step.
[[nodiscard]] SliderRange slider_range(const Range& allowed, double value, bool integer);

}  // namespace camopt::apps
